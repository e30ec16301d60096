// Shows one surprised face. `?webgpu` draws on WebGPU. A click removes the wrinkles.
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js'
import { Engine } from '@babylonjs/core/Engines/engine.js'
import { WebGPUEngine } from '@babylonjs/core/Engines/webgpuEngine.js'
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js'
import { LoadAssetContainerAsync } from '@babylonjs/core/Loading/sceneLoader.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { Scene } from '@babylonjs/core/scene.js'
import '@babylonjs/loaders/glTF/2.0/glTFLoader.js'
import { ExpressionPlayer, registerWrinkleMaps, wrinklesOf } from 'furrow/babylon'

const canvas = document.querySelector('canvas')!

async function createEngine(): Promise<Engine | WebGPUEngine> {
  if (!new URLSearchParams(location.search).has('webgpu')) return new Engine(canvas, true)
  const engine = new WebGPUEngine(canvas, { antialias: true })
  await engine.initAsync()
  return engine
}

registerWrinkleMaps()
const engine = await createEngine()
const scene = new Scene(engine)
const container = await LoadAssetContainerAsync('/wrinkled.glb', scene)
container.addAllToScene()
const [wrinkles] = wrinklesOf(container)
const [root] = container.meshes
if (!wrinkles || !root) throw new Error('no wrinkles')

const { centerWorld, extendSizeWorld } = wrinkles.mesh.getBoundingInfo().boundingBox
const camera = new FreeCamera('camera', centerWorld.add(new Vector3(0, 0, 5 * extendSizeWorld.y)), scene)
camera.setTarget(centerWorld)
camera.fov = 0.4
camera.minZ = 0.01
new DirectionalLight('sun', new Vector3(0.5, -0.5, -1), scene).intensity = 3

new ExpressionPlayer(root, wrinkles).play('surprised', 0)
canvas.addEventListener('click', () => {
  wrinkles.mode = 'off'
})
await scene.whenReadyAsync()
engine.runRenderLoop(() => scene.render())
