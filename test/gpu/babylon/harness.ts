import { Camera } from '@babylonjs/core/Cameras/camera.js'
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js'
import { Constants } from '@babylonjs/core/Engines/constants.js'
import { Engine } from '@babylonjs/core/Engines/engine.js'
import { WebGPUEngine } from '@babylonjs/core/Engines/webgpuEngine.js'
import { RenderTargetTexture } from '@babylonjs/core/Materials/Textures/renderTargetTexture.js'
import { Color4 } from '@babylonjs/core/Maths/math.color.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { Mesh } from '@babylonjs/core/Meshes/mesh.js'
import { VertexData } from '@babylonjs/core/Meshes/mesh.vertexData.js'
import { Scene } from '@babylonjs/core/scene.js'
import { afterAll, beforeAll } from 'vitest'
import { WrinklePlugin } from '../../../packages/furrow/src/babylon/wrinkle-plugin.ts'
import { available } from '../available.ts'

export const ENGINES = available(['webgl', 'webgpu'] as const)
export type EngineName = (typeof ENGINES)[number]

export interface BabylonHarness {
  name: EngineName
  engine: Engine | WebGPUEngine
  /** Creates an empty scene and a camera. The mesh of `square` fills the picture. */
  createScene(): Scene
  /** Renders a scene and reads it back: linear RGBA, floats, row 0 at the bottom. */
  render(scene: Scene, width: number, height?: number): Promise<Float32Array>
  /** Errors reported by the GPU. */
  errors: string[]
  dispose(): void
}

/**
 * Matches the WebGPU error of a lost frame. Every frame clears the texture of the canvas (300 x 150 pixels). A busy browser
 * may destroy this texture before the frame is submitted. Then the GPU drops the complete frame, including render targets.
 */
const LOST_CANVAS = /Destroyed texture \[Texture \(unlabeled 300x150 px/
const ATTEMPTS = 3

/** Creates a harness for all tests in the current `describe`. */
export function harnessOn(name: EngineName): BabylonHarness {
  const harness = {} as BabylonHarness
  beforeAll(async () => void Object.assign(harness, await createHarness(name)))
  afterAll(() => harness.dispose())
  return harness
}

/** Disables anisotropic filtering, which the reference lacks. Disables parallel shader compilation, because tests read the first frame. */
function limitCaps(engine: Engine | WebGPUEngine): void {
  Object.assign(engine.getCaps(), { maxAnisotropy: 1, parallelShaderCompile: undefined })
}

/** Creates an engine. Fails if the engine is not available. */
export async function createHarness(name: EngineName): Promise<BabylonHarness> {
  const canvas = document.createElement('canvas')
  const errors: string[] = []
  let engine: Engine | WebGPUEngine
  if (name === 'webgpu') {
    engine = new WebGPUEngine(canvas)
    await engine.initAsync()
    const { _device: device } = engine as unknown as { _device: EventTarget }
    device.addEventListener('uncapturederror', (event) => {
      errors.push((event as Event & { error: Error }).error.message)
    })
  } else {
    engine = new Engine(canvas, false)
    if (engine.version < 2) throw new Error('WebGL 2 is not available')
  }
  limitCaps(engine)
  engine.onContextRestoredObservable.add(() => limitCaps(engine))
  return {
    name,
    engine,
    errors,
    createScene() {
      const scene = new Scene(engine)
      scene.clearColor = new Color4(0, 0, 0, 0)
      // Leaves tone mapping and gamma to post processing. The scene has no post processing, so colours stay linear.
      scene.imageProcessingConfiguration.applyByPostProcess = true
      const camera = new FreeCamera('camera', new Vector3(0, 0, -5), scene)
      camera.mode = Camera.ORTHOGRAPHIC_CAMERA
      camera.orthoLeft = camera.orthoBottom = -1
      camera.orthoRight = camera.orthoTop = 1
      return scene
    },
    async render(scene, width, height = width) {
      for (let attempt = 1; ; attempt++) {
        const pixels = await renderOnce(scene, width, height)
        const lost = errors.findIndex((error) => LOST_CANVAS.test(error))
        if (lost < 0 || attempt === ATTEMPTS) return pixels
        errors.splice(lost, 1)
        redrawInfluence(scene)
      }
    },
    dispose: () => engine.dispose(),
  }

  async function renderOnce(scene: Scene, width: number, height: number): Promise<Float32Array> {
    const target = new RenderTargetTexture('picture', { width, height }, scene, {
      generateMipMaps: false,
      type: Constants.TEXTURETYPE_FLOAT,
      format: Constants.TEXTUREFORMAT_RGBA,
    })
    const camera = scene.activeCamera!
    camera.outputRenderTarget = target
    // `whenReadyAsync` waits only for the programs of the camera's render pass, but each render target has its own programs.
    const { renderPassId } = camera
    camera.renderPassId = target.renderPassId
    await scene.whenReadyAsync(true)
    camera.renderPassId = renderPassId
    // On WebGPU the canvas texture is lost if the code awaits between beginFrame and endFrame.
    engine.beginFrame()
    scene.render()
    engine.endFrame()
    const pixels = new Float32Array((await target.readPixels()) as Float32Array)
    camera.outputRenderTarget = null
    target.dispose()
    return pixels
  }
}

/** Waits until a scene is ready, and disposes of it. Babylon.js 8 throws if the scene's textures load after the disposal. */
export async function disposeScene(scene: Scene): Promise<void> {
  if (!scene.isDisposed) await scene.whenReadyAsync()
  scene.dispose()
}

/** Makes the next frame redraw the influence maps of a scene, because they were drawn in the lost frame. */
function redrawInfluence({ materials }: Scene): void {
  for (const { pluginManager } of materials) {
    const plugin = pluginManager?.getPlugin<WrinklePlugin>(WrinklePlugin.NAME)
    plugin?.shared?.atlas.cells.invalidate()
  }
}

/**
 * Creates a square that fills the frame. `uv = (x, 1 - y) * scale + offset`, where x and y rise from 0 at the lower left corner to 1. So v points
 * down as in glTF.
 */
export function square(scene: Scene, scale = 1, offset = [0, 0]): Mesh {
  const mesh = new Mesh('square', scene)
  const data = new VertexData()
  data.positions = [-1, 1, 0, 1, 1, 0, -1, -1, 0, 1, -1, 0]
  data.normals = [0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1]
  data.uvs = [0, 0, 1, 0, 0, 1, 1, 1].map((value, i) => value * scale + offset[i % 2])
  data.indices = [0, 2, 1, 2, 3, 1]
  data.applyToMesh(mesh)
  return mesh
}
