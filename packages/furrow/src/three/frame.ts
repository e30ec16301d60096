import type { Scene, WebGLRenderer } from 'three'
import { Frame, type FrameEntry } from '../runtime/frame.ts'
import { InfluenceAtlas } from './atlas/influence-atlas.ts'
import type { QuadMaterials } from './atlas/quad-materials.ts'
import { callBeforeRender } from './mesh/before-render.ts'
import type { AnyRenderer } from './renderer.ts'

/** How often a scene is hooked: a page that puts its own callback in front each time, or another copy of this library, would go on for ever. */
const MOST_HOOKS = 8

/** Images of a scene in a row that show no face, such as those of other cameras, after which faces are taken to be out of sight. */
const MOST_IMAGES = 4

/** A scene in which faces are drawn. */
interface FaceScene {
  /** Called before the scene is drawn; null until it is hooked. */
  hook: Scene['onBeforeRender'] | null
  /** How often it was hooked. */
  hooks: number
  /** Whether it will be hooked after the present frame. */
  isDue: boolean
  /** Frame in which a face was drawn last, and the renderer. */
  last: number
  renderer: AnyRenderer
  /** How many images have begun since. */
  images: number
}

/** The frames of one kind of renderer, and the atlases of their faces. */
export class RendererFrame extends Frame<AnyRenderer, InfluenceAtlas> {
  readonly #materials: QuadMaterials
  readonly #scenes = new WeakMap<Scene, FaceScene>()

  constructor(materials: QuadMaterials) {
    super(renderCount)
    this.#materials = materials
  }

  /** The atlas of all faces with this size of areas, in texels, and number of layers. */
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
   * Compiles what draws the influence of an atlas, after the present frame: the first frame with wrinkles then waits for no program. Not at once,
   * since `compile` of three.js would take the lights of a `compile` or frame that is going on.
   */
  compileLater(atlas: InfluenceAtlas, renderer: WebGLRenderer): void {
    queueMicrotask(() => this.targets.includes(atlas) && atlas.compile(renderer))
  }

  /**
   * Notes a scene in which a member is being drawn. From the next frame on, its frames begin before anything of it is drawn. WebGL would draw
   * influence in the midst of an image, which the GPUs of phones then write to memory and read again (Arm GPU Best Practices, "Efficient render
   * passes"); on WebGPU it is submitted before the image anyway.
   *
   * @param entry of the member.
   */
  noteScene(scene: Scene, { seen }: FrameEntry<AnyRenderer>, renderer: AnyRenderer): void {
    const known = this.#scenes.get(scene)
    if (known) {
      known.last = seen
      known.renderer = renderer
      known.images = 0
      if (known.isDue || known.hook === scene.onBeforeRender || known.hooks === MOST_HOOKS) return
    }
    // three.js has an empty scene for what it draws without one.
    if (scene.isScene && scene.children.length > 0 && drawsAtOnce(renderer)) {
      this.#hookLater(scene, seen, renderer)
    }
  }

  /** A method of its own: closures allocate in every call. */
  #hookLater(scene: Scene, last: number, renderer: AnyRenderer): void {
    const hooks = (this.#scenes.get(scene)?.hooks ?? 0) + 1
    const own: FaceScene = { hook: null, hooks, isDue: true, last, renderer, images: 0 }
    this.#scenes.set(scene, own)
    queueMicrotask(() => this.#hook(scene, own))
  }

  #hook(scene: Scene, own: FaceScene): void {
    own.isDue = false
    if (this.targets.length === 0) return
    const stop = callBeforeRender(scene, (by, _camera, { overrideMaterial }) => {
      // The page may have wrapped an earlier hook, which is called too.
      if (this.#scenes.get(scene) !== own) return
      if (this.targets.length === 0) {
        stop()
        this.#scenes.delete(scene)
      } else if (by === own.renderer && !overrideMaterial && drawsAtOnce(by)) {
        if (++own.images <= MOST_IMAGES) this.beginImage(by, own.last, 'calls' in by.info)
      }
    })
    own.hook = scene.onBeforeRender
  }

  /** Draws an atlas in frames again that was released. */
  restore(atlas: InfluenceAtlas): void {
    if (!this.targets.includes(atlas)) this.targets.push(atlas)
  }

  /** Frees an atlas if no face uses it any more. */
  release(atlas: InfluenceAtlas): void {
    if (!atlas.cells.isEmpty) return
    atlas.dispose()
    this.targets.splice(this.targets.indexOf(atlas), 1)
  }
}

const frames = new Map<QuadMaterials, RendererFrame>()

/** The frames of a kind of renderer, one object for all its faces. */
export function frameOf(materials: QuadMaterials): RendererFrame {
  const frame = frames.get(materials) ?? new RendererFrame(materials)
  frames.set(materials, frame)
  return frame
}

/** Changes with every call of `render`, nested ones included. */
function renderCount({ info }: AnyRenderer): number {
  return 'calls' in info ? info.calls : info.render.frame
}

/** Whether a renderer draws by WebGL, and draws: `compileAsync` of `WebGPURenderer` goes through scenes too. */
function drawsAtOnce(renderer: AnyRenderer): boolean {
  const { backend, _compilationPromises } = renderer as {
    backend?: { isWebGPUBackend?: true }
    _compilationPromises?: object | null
  }
  return !backend?.isWebGPUBackend && !_compilationPromises
}
