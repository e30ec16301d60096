import type { Scene } from 'three'
import { Frame, type FrameEntry } from '../runtime/frame.ts'
import { InfluenceAtlas } from './atlas/influence-atlas.ts'
import type { QuadMaterials } from './atlas/quad-materials.ts'
import { callBeforeRender } from './mesh/before-render.ts'
import type { AnyRenderer } from './renderer.ts'

/** The frames of one kind of renderer, and the atlases of their faces. */
export class RendererFrame extends Frame<AnyRenderer, InfluenceAtlas> {
  readonly #materials: QuadMaterials
  /** What each scene calls before it is drawn. */
  readonly #watched = new WeakMap<Scene, Scene['onBeforeRender']>()

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
   * Begins the frames of a scene before anything of it is drawn. WebGL would draw influence in the midst of an image, which the GPUs of phones then
   * write to memory and read again (Arm GPU Best Practices, "Efficient render passes"); on WebGPU it is submitted before the image anyway.
   *
   * @param entry of a member that is being drawn in the scene.
   */
  watch(scene: Scene, { seen }: FrameEntry<AnyRenderer>, renderer: AnyRenderer): void {
    const isWatched = this.#watched.get(scene) === scene.onBeforeRender
    if (!isWatched && scene.isScene && drawsAtOnce(renderer)) this.#watch(scene, seen)
  }

  /** What it makes for its callback would else be made in every frame. */
  #watch(scene: Scene, seen: number): void {
    let last = seen
    const stop = callBeforeRender(scene, (by, _camera, { overrideMaterial }) => {
      // The page may have wrapped an earlier one, which is called too.
      if (this.#watched.get(scene) !== watcher) return
      if (this.targets.length === 0) stop()
      else if (!overrideMaterial && drawsAtOnce(by)) last = this.beginImage(by, last, 'calls' in by.info)
    })
    const watcher = scene.onBeforeRender
    this.#watched.set(scene, watcher)
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
