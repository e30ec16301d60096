import type { Scene, WebGLRenderer } from 'three'
import { Frame, type FrameEntry } from '../runtime/frame.ts'
import { InfluenceAtlas } from './atlas/influence-atlas.ts'
import type { QuadMaterials } from './atlas/quad-materials.ts'
import { callBeforeRender } from './mesh/before-render.ts'
import type { AnyRenderer } from './renderer.ts'

/**
 * Maximum number of times that Furrow sets `onBeforeRender` of one scene. Without a limit, Furrow and the page (or another copy of Furrow)
 * could replace each other's callback forever.
 */
const MAX_HOOKS = 8

/** Maximum number of consecutive renders of a scene that update its faces without drawing any face. */
const MAX_RENDERS = 4

interface FaceScene {
  /** Furrow's `onBeforeRender` callback; null until Furrow has set it. */
  hook: Scene['onBeforeRender'] | null
  /** Number of times that Furrow set `onBeforeRender`. */
  hooks: number
  /** Whether Furrow will set `onBeforeRender` after the current frame. */
  isDue: boolean
  /** Number of the frame that last drew a face of the scene. */
  last: number
  /** Renderer of the frame `last`. */
  renderer: AnyRenderer
  /** Number of renders of the scene since the frame `last`. */
  renders: number
}

/**
 * Updates all faces of one kind of renderer once per frame, in phases: inputs, drivers, activations, influence maps. An influence map holds,
 * in UV space, how strongly each layer of wrinkles is visible. Atlases hold the influence maps of several faces.
 */
export class RendererFrame extends Frame<AnyRenderer, InfluenceAtlas> {
  readonly #materials: QuadMaterials
  readonly #scenes = new WeakMap<Scene, FaceScene>()

  constructor(materials: QuadMaterials) {
    super(renderCount)
    this.#materials = materials
  }

  /** Returns the atlas of influence maps shared by all faces with the same resolution of areas (in texels) and number of layers. */
  atlasFor(width: number, height: number, layers: number): InfluenceAtlas {
    const shared = this.targets.find(
      (atlas) => atlas.cells.width === width && atlas.cells.height === height && atlas.layers === layers,
    )
    if (shared) return shared
    const atlas = new InfluenceAtlas(width, height, layers, this.#materials)
    this.targets.push(atlas)
    return atlas
  }

  /**
   * Compiles the shaders that draw an atlas, so that the first frame with wrinkles does not wait for them. Waits for the end of the current
   * `render` or `compile` call: a nested `compile` would overwrite the light state of that call.
   */
  compileLater(atlas: InfluenceAtlas, renderer: WebGLRenderer): void {
    queueMicrotask(() => this.targets.includes(atlas) && atlas.compile(renderer))
  }

  /**
   * Registers a scene in which a face is being drawn. From the next frame on, the phases run before the scene's first draw call.
   *
   * On WebGL, drawing influence maps in the middle of a render pass makes tiled mobile GPUs store and reload the render target (Arm GPU Best
   * Practices, "Efficient render passes"). With WebGPU the scene is not registered, because the influence maps are submitted to the GPU
   * before the pass in any case.
   */
  trackScene(scene: Scene, { seen }: FrameEntry<AnyRenderer>, renderer: AnyRenderer): void {
    const known = this.#scenes.get(scene)
    if (known) {
      known.last = seen
      known.renderer = renderer
      known.renders = 0
      if (known.isDue || known.hook === scene.onBeforeRender || known.hooks === MAX_HOOKS) return
    }
    // three.js passes an empty scene if `render` was called with an object that is not a Scene.
    if (scene.isScene && scene.children.length > 0 && drawsImmediately(renderer)) {
      this.#hookLater(scene, seen, renderer)
    }
  }

  /** Separate method, because `trackScene` runs in every frame and closures in it would allocate each time. */
  #hookLater(scene: Scene, last: number, renderer: AnyRenderer): void {
    const hooks = (this.#scenes.get(scene)?.hooks ?? 0) + 1
    const faceScene: FaceScene = { hook: null, hooks, isDue: true, last, renderer, renders: 0 }
    this.#scenes.set(scene, faceScene)
    queueMicrotask(() => this.#hook(scene, faceScene))
  }

  #hook(scene: Scene, faceScene: FaceScene): void {
    faceScene.isDue = false
    if (this.targets.length === 0) return
    const stop = callBeforeRender(scene, (by, _camera, { overrideMaterial }) => {
      // If the page wrapped an earlier hook of Furrow, the earlier hook still runs. Only the latest hook may call `beginImage`.
      if (this.#scenes.get(scene) !== faceScene) return
      if (this.targets.length === 0) {
        stop()
        this.#scenes.delete(scene)
      } else if (by === faceScene.renderer && !overrideMaterial && drawsImmediately(by)) {
        if (++faceScene.renders <= MAX_RENDERS) this.beginImage(by, faceScene.last, 'calls' in by.info)
      }
    })
    faceScene.hook = scene.onBeforeRender
  }

  restore(atlas: InfluenceAtlas): void {
    if (!this.targets.includes(atlas)) this.targets.push(atlas)
  }

  /** Disposes of an atlas that no face uses. */
  release(atlas: InfluenceAtlas): void {
    if (!atlas.cells.isEmpty) return
    atlas.dispose()
    this.targets.splice(this.targets.indexOf(atlas), 1)
  }
}

const frames = new Map<QuadMaterials, RendererFrame>()

/** Returns the frame shared by all faces of one kind of renderer. */
export function frameOf(materials: QuadMaterials): RendererFrame {
  const frame = frames.get(materials) ?? new RendererFrame(materials)
  frames.set(materials, frame)
  return frame
}

/** Returns the number of `render` calls, including nested ones. */
function renderCount({ info }: AnyRenderer): number {
  return 'calls' in info ? info.calls : info.render.frame
}

/** Whether a renderer sends draw calls to the GPU while it traverses a scene. False for WebGPU, and while a scene is only compiled. */
function drawsImmediately(renderer: AnyRenderer): boolean {
  const { backend, _compilationPromises } = renderer as {
    backend?: { isWebGPUBackend?: true }
    _compilationPromises?: object | null
  }
  return !backend?.isWebGPUBackend && !_compilationPromises
}
