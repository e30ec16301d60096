import {
  FloatType,
  HalfFloatType,
  RedFormat,
  RenderTarget,
  RGBAFormat,
  RGFormat,
  type TextureDataType,
} from 'three'
import { AtlasCells, type Cell } from '../../runtime/atlas-cells.ts'
import type { Face } from '../../runtime/face.ts'
import type { InfluenceTarget } from '../../runtime/frame.ts'
import { type AnyRenderer, filtersFloats } from '../renderer.ts'
import type { AreaArray } from './area-array.ts'
import { InfluencePass, type QuadMaterials } from './influence-pass.ts'

const FORMATS = [RedFormat, RGFormat, RGBAFormat, RGBAFormat] as const

/** More channels of whole floats than these take graphics cards several steps to filter. */
const MOST_WHOLE_FLOATS = 2

/**
 * The influence maps of all faces of one kind, side by side in one texture: per layer, the sum of a face's areas times their
 * activations, in UV space at the areas' resolution. A cell is redrawn only when an activation of its face has changed, and then only
 * over the rectangles of active areas; one pass draws all cells of a frame. Shaders of faces take one sample of it, however many areas
 * there are.
 *
 * Texels hold T = max(sum, largest `max`), unclamped; shaders take min(1, T) after interpolation, and so clamp exactly where the reference
 * does. They are whole floats where these can be filtered and added up, else half ones: a software rasteriser has to convert halves,
 * four of them for each sample, which costs as much as a texture of bytes. Bytes cannot hold what passes 1.
 */
export class InfluenceAtlas implements InfluenceTarget<AnyRenderer> {
  readonly layers: number
  readonly target: RenderTarget
  readonly cells: AtlasCells
  readonly #pass: InfluencePass
  #renderer: AnyRenderer | null = null

  /**
   * @param width of a cell and of the faces' areas, in texels.
   * @param height the same.
   * @param layers number of the faces' layers, with one channel each.
   */
  constructor(width: number, height: number, layers: number, materials: QuadMaterials) {
    this.layers = layers
    this.cells = new AtlasCells(width, height)
    this.target = new RenderTarget(width, height, {
      format: FORMATS[layers - 1],
      type: HalfFloatType,
      depthBuffer: false,
    })
    this.#pass = new InfluencePass(this.cells, this.target, materials)
  }

  /**
   * Allocates consecutive cells to faces.
   *
   * @throws FurrowError when they do not fit into the largest texture.
   */
  add(faces: readonly Face[]): Cell[] {
    const added = this.cells.add(faces)
    const { width, height, grid } = this.cells
    this.target.setSize(grid.columns * width, grid.rows * height)
    return added
  }

  /** Frees cells. */
  remove(cells: readonly Cell[]): void {
    this.cells.remove(cells)
    this.prune()
  }

  /** Frees the resources of arrays of areas that no face uses any more. */
  prune(): void {
    this.#pass.prune(this.cells.slots as Set<AreaArray>)
  }

  /** Collects those of some cells that have changed, for `draw`. */
  collect(cells: readonly Cell[], renderer: AnyRenderer): void {
    this.#checkContents(renderer)
    this.cells.collect(cells)
  }

  /** Draws the cells that were collected. */
  draw(renderer: AnyRenderer): void {
    const { changed, changes } = this.cells
    if (changes > 0) this.#pass.draw(renderer, changed, changes)
    this.cells.changes = 0
  }

  /** Compiles what draws it, unless it has drawn already. */
  compile(renderer: AnyRenderer): void {
    if (renderer !== this.#renderer) this.#pass.compile(renderer, this.cells.slots as Set<AreaArray>)
  }

  dispose(): void {
    this.target.dispose()
    this.#pass.dispose()
  }

  /** What was drawn is missing in another renderer, and after a lost context. */
  #checkContents(renderer: AnyRenderer): void {
    if (renderer === this.#renderer && this.#pass.hasContents(renderer)) return
    this.#renderer = renderer
    this.#setType(this.layers <= MOST_WHOLE_FLOATS && filtersFloats(renderer) ? FloatType : HalfFloatType)
    this.cells.invalidate()
  }

  #setType(type: TextureDataType): void {
    const { texture } = this.target
    if (texture.type === type) return
    texture.type = type
    this.target.dispose()
  }
}
