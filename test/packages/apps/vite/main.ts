// Shows one surprised face. `?webgpu` draws on WebGPURenderer. A click removes the wrinkles.
import { ExpressionPlayer, frameFace, wrinklesOf } from 'furrow/three'
import { DirectionalLight, PerspectiveCamera, Scene } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

const query = new URLSearchParams(location.search)
const { renderer, plugin } = query.has('webgpu') ? await import('./webgpu.ts') : await import('./webgl.ts')

const file = await new GLTFLoader().register(plugin).loadAsync('/wrinkled.glb')
const [wrinkles] = wrinklesOf(file)
const player = new ExpressionPlayer(file.scene, wrinkles)
player.play('surprised', 0)

const scene = new Scene().add(file.scene, new DirectionalLight('white', 3).translateX(-0.5).translateZ(1))
const camera = new PerspectiveCamera(22, innerWidth / innerHeight)
frameFace(camera, file.scene)
renderer.setSize(innerWidth, innerHeight)
renderer.domElement.addEventListener('click', () => {
  if (wrinkles) wrinkles.mode = wrinkles.mode === 'off' ? 'default' : 'off'
})
document.body.append(renderer.domElement)
await renderer.setAnimationLoop(() => {
  player.update()
  renderer.render(scene, camera)
})
