/** Page that renders a face with Babylon.js and Furrow, as `page.ts` does with three.js. `?webgpu` selects WebGPU instead of WebGL. */
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js'
import { Engine } from '@babylonjs/core/Engines/engine.js'
import { WebGPUEngine } from '@babylonjs/core/Engines/webgpuEngine.js'
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js'
import { HemisphericLight } from '@babylonjs/core/Lights/hemisphericLight.js'
import { LoadAssetContainerAsync } from '@babylonjs/core/Loading/sceneLoader.js'
import { Color3, Color4 } from '@babylonjs/core/Maths/math.color.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { Scene } from '@babylonjs/core/scene.js'
import '@babylonjs/loaders/glTF/2.0/Extensions/KHR_materials_ior.js'
import '@babylonjs/loaders/glTF/2.0/Extensions/KHR_materials_specular.js'
import '@babylonjs/loaders/glTF/2.0/Extensions/KHR_mesh_quantization.js'
import '@babylonjs/loaders/glTF/2.0/Extensions/KHR_texture_transform.js'
import '@babylonjs/loaders/glTF/2.0/glTFLoader.js'
import { registerWrinkleMaps, wrinklesOf } from 'furrow/babylon'
import type { Description } from './page.ts'
import { AMBIENT, LAMPS, type Shot, SIZE } from './shots.ts'

declare global {
  interface Window {
    /** Renders a face in the pose of a shot. Returns the picture as a PNG data URL, and the activations by area name. */
    drawWithBabylon(
      address: string,
      shot: Shot,
      camera: Description['camera'],
    ): Promise<{ url: string; activations: Record<string, number> }>
  }
}

/** Background colour. Needed because the canvas is opaque on WebGPU. */
const BACKGROUND = [40 / 255, 40 / 255, 40 / 255, 1] as const

/** Number of frames to draw before the picture, so that shaders are compiled and `time` drivers have reached their final activations. */
const FRAMES = 10

registerWrinkleMaps()

window.drawWithBabylon = async (address, shot, { position, target, fov }) => {
  const canvas = document.createElement('canvas')
  canvas.width = canvas.height = SIZE
  const engine = await createEngine(canvas)
  const scene = new Scene(engine)
  scene.useRightHandedSystem = true
  scene.clearColor = new Color4(...BACKGROUND)
  const camera = new FreeCamera('camera', Vector3.FromArray(position), scene)
  camera.setTarget(Vector3.FromArray(target))
  Object.assign(camera, { fov: (fov * Math.PI) / 180, minZ: 0.01, maxZ: 100 })
  const container = await LoadAssetContainerAsync(address, scene)
  container.addAllToScene()
  for (const { morphTargetManager } of container.meshes) {
    for (let i = 0; i < (morphTargetManager?.numTargets ?? 0); i++) {
      const morph = morphTargetManager!.getTarget(i)
      morph.influence = shot.targets[morph.name] ?? 0
    }
  }
  light(scene)
  const [wrinkles] = wrinklesOf(container)
  let milliseconds = 0
  wrinkles.clock = { now: () => milliseconds }
  await scene.whenReadyAsync()
  for (let i = 0; i < FRAMES; i++) {
    // 10 s per frame, far longer than `time` drivers delay activations.
    milliseconds += 10_000
    engine.beginFrame()
    scene.render()
    engine.endFrame()
    await new Promise((resolve) => setTimeout(resolve, 20))
  }
  engine.beginFrame()
  scene.render()
  engine.endFrame()
  const activations = wrinkles.areaNames.map((name) => [name, wrinkles.getActivation(name)])
  return { url: canvas.toDataURL(), activations: Object.fromEntries(activations) }
}

async function createEngine(canvas: HTMLCanvasElement): Promise<Engine | WebGPUEngine> {
  const settings = { preserveDrawingBuffer: true, antialias: true }
  if (location.search !== '?webgpu') return new Engine(canvas, true, settings)
  const engine = new WebGPUEngine(canvas, settings)
  await engine.initAsync()
  return engine
}

/** Adds lights without shadows. A hemispheric light with equal colours and no highlights serves as uniform ambient light. */
function light(scene: Scene): void {
  const sky = new HemisphericLight('ambient', Vector3.Up(), scene)
  sky.diffuse = sky.groundColor = Color3.White().scale(AMBIENT)
  sky.specular = Color3.Black()
  for (const { from, strength } of LAMPS) {
    const lamp = new DirectionalLight('lamp', Vector3.FromArray(from).scale(-1).normalize(), scene)
    lamp.intensity = strength
  }
}
