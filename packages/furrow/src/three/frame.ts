import type { Scene, WebGLRenderer } from 'three'
import { Frame, type FrameEntry } from '../runtime/frame.ts'
import { InfluenceAtlas } from './atlas/influence-atlas.ts'
import type { QuadMaterials } from './atlas/quad-materials.ts'
import { callBeforeRender } from './mesh/before-render.ts'
import type { AnyRenderer } from './renderer.ts'

/**
 * Maximum number of times that one scene is hooked. A page, or another copy of Furrow, may replace `onBeforeRender` after every hook; the
 * limit ends this loop.
 */
const MAX_HOOKS = 8

/** The faces of a scene count as out of sight after this many consecutive renders that draw none of them, e.g. from other cameras. */
const MAX_RENDERS = 4

/** A scene that contains faces. */
interface FaceScene {
  /** Furrow's `onBeforeRender` callback; null until the scene is hooked. */
  hook: Scene['onBeforeRender'] | null
  /** Number of times the scene was hooked. */
  hooks: number
  /** Whether the scene will be hooked after the current frame. */
  isDue: boolean
  /** Frame that last drew a face, and its renderer. */
  last: number
  renderer: AnyRenderer
  /** Number of renders of the scene since then. */
  renders: number
}

/** Frame phases for one kind of renderer, with the atlases of its faces. */
export class RendererFrame extends Frame<AnyRenderer, InfluenceAtlas> {
  readonly #materials: QuadMaterials
  readonly #scenes = new WeakMap<Scene, FaceScene>()

  constructor(materials: QuadMaterials) {
    super(renderCount)
    this.#materials = materials
  }

  /** Returns the atlas shared by all faces with this area size (texels) and number of layers. */
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
   * Compiles the programs that draw an atlas, after the current frame, so that the first frame with wrinkles does not wait for them. Deferred
   * because three.js's `compile` clobbers the light state of a `compile` or `render` in progress.
   */
  compileLater(atlas: InfluenceAtlas, renderer: WebGLRenderer): void {
    queueMicrotask(() => this.targets.includes(atlas) && atlas.compile(renderer))
  }

  /**
   * Registers a scene in which a member is being drawn. From the next frame on, the phases run before the scene's first draw call.
   *
   * On WebGL, drawing influence in the middle of a render pass makes tiled mobile GPUs store and reload the target (Arm GPU Best Practices,
   * "Efficient render passes"). WebGPU submits influence first anyway.
   */
  trackScene(scene: Scene, { seen }: FrameEntry<AnyRenderer>, renderer: AnyRenderer): void {
    const known = this.#scenes.get(scene)
    if (known) {
      known.last = seen
      known.renderer = renderer
      known.renders = 0
      if (known.isDue || known.hook === scene.onBeforeRender || known.hooks === MAX_HOOKS) return
    }
    // three.js passes an empty scene when the rendered root is not a Scene.
    if (scene.isScene && scene.children.length > 0 && drawsImmediately(renderer)) {
      this.#hookLater(scene, seen, renderer)
    }
  }

  /** Separate method: its closures would allocate in every call of `trackScene`. */
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
      // The page may have wrapped an earlier hook, which still runs.
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

  /** Adds a released atlas again. */
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

/** Number of `render` calls, including nested ones. */
function renderCount({ info }: AnyRenderer): number {
  return 'calls' in info ? info.calls : info.render.frame
}

/** Whether a renderer draws objects while it traverses the scene. `WebGPURenderer` also traverses scenes to compile them. */
function drawsImmediately(renderer: AnyRenderer): boolean {
  const { backend, _compilationPromises } = renderer as {
    backend?: { isWebGPUBackend?: true }
    _compilationPromises?: object | null
  }
  return !backend?.isWebGPUBackend && !_compilationPromises
}
