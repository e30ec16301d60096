import { Frame } from '../runtime/frame.ts'
import { InfluenceAtlas } from './atlas/influence-atlas.ts'
import type { QuadMaterials } from './atlas/quad-materials.ts'
import type { AnyRenderer } from './renderer.ts'

/** The frames of one kind of renderer, and the atlases of their faces. */
export class RendererFrame extends Frame<AnyRenderer, InfluenceAtlas> {
  readonly #materials: QuadMaterials

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
