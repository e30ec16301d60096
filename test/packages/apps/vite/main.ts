// One surprised face: `?webgpu` draws it on WebGPURenderer, a click without its wrinkles.
import { ExpressionPlayer, frameFace, type WrinklesBase } from 'furrow/three'
import { DirectionalLight, PerspectiveCamera, Scene } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

const query = new URLSearchParams(location.search)
const { renderer, plugin } = query.has('webgpu') ? await import('./webgpu.ts') : await import('./webgl.ts')

const { scene: face, userData } = await new GLTFLoader().register(plugin).loadAsync('/wrinkled.glb')
const wrinkles: WrinklesBase = userData.wrinkles[0]
const player = new ExpressionPlayer(face, wrinkles)
player.play('surprised', 0)

const scene = new Scene().add(face, new DirectionalLight('white', 3).translateX(-0.5).translateZ(1))
const camera = new PerspectiveCamera(22, innerWidth / innerHeight)
frameFace(camera, face)
renderer.setSize(innerWidth, innerHeight)
renderer.domElement.addEventListener('click', () => {
  wrinkles.mode = wrinkles.mode === 'off' ? 'default' : 'off'
})
document.body.append(renderer.domElement)
await renderer.setAnimationLoop(() => {
  player.update()
  renderer.render(scene, camera)
})
