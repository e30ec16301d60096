/** Page that measures the frame time of a face in Babylon.js with and without wrinkles. `run.mjs` opens it. */
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js'
import { Engine } from '@babylonjs/core/Engines/engine.js'
import { WebGPUEngine } from '@babylonjs/core/Engines/webgpuEngine.js'
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js'
import { HemisphericLight } from '@babylonjs/core/Lights/hemisphericLight.js'
import { LoadAssetContainerAsync } from '@babylonjs/core/Loading/sceneLoader.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { Scene } from '@babylonjs/core/scene.js'
import '@babylonjs/loaders/glTF/2.0/Extensions/KHR_materials_ior.js'
import '@babylonjs/loaders/glTF/2.0/Extensions/KHR_materials_specular.js'
import '@babylonjs/loaders/glTF/2.0/Extensions/KHR_mesh_quantization.js'
import '@babylonjs/loaders/glTF/2.0/Extensions/KHR_texture_transform.js'
import '@babylonjs/loaders/glTF/2.0/glTFLoader.js'
import { registerWrinkleMaps, wrinklesOf } from 'furrow/babylon'
import type { RendererKind } from '../../stage/stage.ts'
import { changedFraction } from '../page/changed.ts'
import { LIGHT_INTENSITY, LIGHTS } from '../page/lights.ts'
import { type Clock, passClock, queryClock } from '../page/timestamps.ts'
import { roundOrder } from '../statistics.ts'

export interface BabylonTimes {
  adapter: string
  /** Milliseconds per frame, one number per round: `plain` without wrinkles, `furrow` with them. */
  plain: number[]
  furrow: number[]
  /** Fraction of pixels that the wrinkles change, 0..1. */
  changed: number
}

declare global {
  interface Window {
    timeBabylon(kind: RendererKind, width: number, height: number, rounds: number): Promise<BabylonTimes>
  }
}

type AnyEngine = Engine | WebGPUEngine

const BLENDSHAPES = [
  'browInnerUp',
  'browDownLeft',
  'browDownRight',
  'noseSneerLeft',
  'mouthSmileLeft',
  'jawOpen',
]
/** Number of frames that are drawn before timing, while shaders compile. */
const WARM_UP = 20
/** Number of frames that are timed together. The WebGPU clock can time at most 2048 render passes together. */
const FRAMES = 32

registerWrinkleMaps()

window.timeBabylon = async (kind, width, height, rounds) => {
  const canvas = Object.assign(document.createElement('canvas'), { width, height })
  const { engine, adapter, clock } = await (kind === 'webgl' ? webgl(canvas) : webgpu(canvas))
  const times: BabylonTimes = { adapter, plain: [], furrow: [], changed: 0 }
  const names = ['plain', 'furrow'] as const
  for (let round = 0; round < rounds; round++) {
    const faces = await Promise.all(names.map((name) => createFace(engine, name === 'furrow')))
    for (const face of faces) for (let i = 0; i < WARM_UP; i++) await face.warmUp(i)
    if (round === 0) times.changed = changedFraction(await faces[0].picture(), await faces[1].picture())
    for (const i of [0, ...roundOrder(names.length, round)]) {
      const milliseconds = await clock(() => {
        for (let frame = 0; frame < FRAMES; frame++) faces[i].draw(frame)
      })
      times[names[i]][round] = milliseconds / FRAMES
    }
    for (const { scene } of faces) scene.dispose()
  }
  return times
}

async function webgl(canvas: HTMLCanvasElement) {
  const engine = new Engine(canvas, false, { preserveDrawingBuffer: true })
  return {
    engine,
    adapter: engine.getGlInfo().renderer,
    clock: requireClock(queryClock(engine._gl as WebGL2RenderingContext)),
  }
}

async function webgpu(canvas: HTMLCanvasElement) {
  const engine = new WebGPUEngine(canvas, {
    antialias: false,
    deviceDescriptor: { requiredFeatures: ['timestamp-query'] },
  })
  await engine.initAsync()
  const { vendor, architecture, description } = engine._device.adapterInfo
  return {
    engine,
    adapter: `${vendor} ${architecture} ${description}`.trim(),
    clock: requireClock(passClock(engine._device)),
  }
}

function requireClock(clock: Clock | undefined): Clock {
  if (clock) return clock
  throw new Error(
    'bench: the GPU has no timestamps, which timing Babylon.js requires; use another GPU or browser',
  )
}

/** Loads the face into a new scene whose camera shows it from forehead to mouth. */
async function createFace(engine: AnyEngine, isWrinkled: boolean) {
  const scene = new Scene(engine)
  scene.useRightHandedSystem = true
  const container = await LoadAssetContainerAsync('/faces/human.glb', scene)
  container.addAllToScene()
  const [wrinkles] = wrinklesOf(container)
  if (!isWrinkled) wrinkles.dispose()
  for (const mesh of container.meshes)
    mesh.setEnabled(mesh.getTotalVertices() === 0 || mesh === wrinkles.mesh)
  const middle = wrinkles.mesh.getBoundingInfo().boundingBox.centerWorld
  const camera = new FreeCamera('camera', middle.add(new Vector3(0, 0.025, 1)), scene)
  camera.setTarget(middle.add(new Vector3(0, 0.025, 0)))
  Object.assign(camera, { fov: 0.1, minZ: 0.01, maxZ: 10 })
  for (const from of LIGHTS) {
    const lamp = new DirectionalLight('lamp', Vector3.FromArray(from).scale(-1).normalize(), scene)
    lamp.intensity = LIGHT_INTENSITY
  }
  new HemisphericLight('ambient', Vector3.Up(), scene).intensity = 0.6
  const morphs = wrinkles.mesh.morphTargetManager!
  const targets = BLENDSHAPES.map((name) => morphs.getTargetByName(name)!)
  const draw = (frame: number) => {
    for (const [i, target] of targets.entries()) {
      target.influence = 0.5 + 0.5 * Math.sin(frame * 0.37 + i * 2.4)
    }
    engine.beginFrame()
    scene.render()
    engine.endFrame()
  }
  await scene.whenReadyAsync()
  return {
    scene,
    draw,
    async warmUp(frame: number) {
      draw(frame)
      await new Promise((resolve) => setTimeout(resolve, 5))
    },
    async picture() {
      draw(0)
      return (await engine.readPixels(0, 0, engine.getRenderWidth(), engine.getRenderHeight())) as Uint8Array
    },
  }
}
