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
  /** Creates an empty scene with a camera that `square` fills. */
  createScene(): Scene
  /** Renders a scene and reads it back: linear RGBA, floats, row 0 at the bottom. */
  render(scene: Scene, width: number, height?: number): Promise<Float32Array>
  /** Errors reported by the GPU. */
  errors: string[]
  dispose(): void
}

/**
 * WebGPU error of a lost frame. A busy browser may take back the canvas texture, 300 x 150 by default, before a frame
 * that clears it is submitted. The GPU then drops the complete frame, including render targets.
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

/** The reference is bilinear, and pictures are read after the first frame. */
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
      // Keeps colours linear, without tone mapping.
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
    // Each render target has its own programs. Babylon.js waits only for those of the camera; others compile during the frame.
    const { renderPassId } = camera
    camera.renderPassId = target.renderPassId
    await scene.whenReadyAsync(true)
    camera.renderPassId = renderPassId
    // Waiting inside a frame loses the canvas texture on WebGPU.
    engine.beginFrame()
    scene.render()
    engine.endFrame()
    const pixels = new Float32Array((await target.readPixels()) as Float32Array)
    camera.outputRenderTarget = null
    target.dispose()
    return pixels
  }
}

/** Disposes of a scene when it is ready. Babylon.js 8 fails if it prepares its own textures after disposal. */
export async function disposeScene(scene: Scene): Promise<void> {
  if (!scene.isDisposed) await scene.whenReadyAsync()
  scene.dispose()
}

/** Redraws the scene's influence maps with the next frame, because a lost frame loses them too. */
function redrawInfluence({ materials }: Scene): void {
  for (const { pluginManager } of materials) {
    const plugin = pluginManager?.getPlugin<WrinklePlugin>(WrinklePlugin.NAME)
    plugin?.shared?.atlas.cells.invalidate()
  }
}

/** Creates a square that fills the frame. `uv = (x, 1 - y) * scale + offset`, v pointing down as in glTF. */
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
