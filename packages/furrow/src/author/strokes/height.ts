import type { GrayImage } from '../../core/types.ts'
import type { Metric } from '../metric.ts'
import type { SkinCanvas } from '../skin/canvas.ts'
import type { Stroke } from './document.ts'
import { addStroke, HeightSum, sharpestAt } from './height-sum.ts'
import { type LaidStroke, layOutStrokes, reachOf } from './lay-out.ts'
import { LineGrid, type LineVisitor } from './line-grid.ts'
import type { OtherStrokes } from './other-strokes.ts'

/** Height map of the skin. */
export interface HeightMap {
  width: number
  height: number
  /** Millimetres above (+) or below (-) the smooth skin: `width * height` values, row 0 is at v = 0. */
  data: Float32Array
}

/** Heights and occlusion drawn from strokes. */
export interface DrawnStrokes {
  heights: HeightMap
  /** 255 = unoccluded. */
  occlusion: GrayImage
}

/**
 * Draws strokes (wrinkles) as a height map. Distances are measured in 3D, so texture stretch and UV seams do not show. Where strokes overlap,
 * `HeightSum` combines their heights; the order of strokes does not matter. Wrinkles narrower than three texels are drawn wider and
 * shallower. Parts of strokes outside the skin are skipped.
 *
 * @param progress called with the progress as a number of strokes (not rounded), and with the total number of strokes.
 * @throws FurrowError if the strokes are longer than 100 m in total.
 */
export function strokesToHeight(
  strokes: readonly Stroke[],
  canvas: SkinCanvas,
  progress?: (done: number, total: number) => void,
): HeightMap {
  const laid = layOutStrokes(strokes, canvas).flat()
  return drawStrokes(laid, canvas, (fraction) => progress?.(fraction * strokes.length, strokes.length))
    .heights
}

/** Draws heights and occlusion of strokes that `layOutStrokes` has laid on the skin. */
export function drawStrokes(
  strokes: readonly LaidStroke[],
  { texels, metric }: Pick<SkinCanvas, 'texels' | 'metric'>,
  progress?: (fraction: number) => void,
): DrawnStrokes {
  const drawn = flatSkin(texels.width, texels.height)
  const pen = new StrokePen(strokes, metric, drawn)
  texels.visitNear(
    pen.isNear,
    (texel, position, normal) => {
      pen.draw(texel, position, normal)
    },
    progress,
  )
  return drawn
}

/** Returns the maps of skin without strokes. */
export function flatSkin(width: number, height: number): DrawnStrokes {
  const texels = width * height
  return {
    heights: { width, height, data: new Float32Array(texels) },
    occlusion: { width, height, data: new Uint8Array(texels).fill(255) },
  }
}

/** Draws strokes texel by texel. A stroke changes only texels within its reach (`reachOf`). */
export class StrokePen {
  /** Returns whether a stroke may reach into a box, given by its lowest and highest x, y and z in millimetres. */
  readonly isNear: LineGrid['isNear']
  readonly #strokes: readonly LaidStroke[]
  readonly #grid: LineGrid
  readonly #metric: Metric
  readonly #drawn: DrawnStrokes
  readonly #others: OtherStrokes | undefined
  readonly #sum = new HeightSum()
  #sharpest = 0

  /**
   * @param drawn receives the maps.
   * @param others further strokes to draw, whose contributions to each texel are cached.
   */
  constructor(strokes: readonly LaidStroke[], metric: Metric, drawn: DrawnStrokes, others?: OtherStrokes) {
    this.#strokes = strokes
    this.#grid = new LineGrid(strokes, strokes.map(reachOf))
    this.#metric = metric
    this.#drawn = drawn
    this.#others = others
    this.isNear = this.#grid.isNear
  }

  /**
   * Draws a texel.
   *
   * @param position position of the texel on the skin.
   * @param normal normal of the skin at the position.
   * @returns whether the texel changed.
   */
  draw(texel: number, position: Float64Array, normal: Float64Array): boolean {
    const { heights, occlusion } = this.#drawn
    this.#sharpest = sharpestAt(this.#metric, texel)
    this.#addAll(texel, position, normal)
    const { height, open } = this.#sum
    if (heights.data[texel] === height && occlusion.data[texel] === open) return false
    heights.data[texel] = height
    occlusion.data[texel] = open
    return true
  }

  #addAll(texel: number, position: Float64Array, normal: Float64Array): void {
    const sum = this.#sum
    if (!this.#others) {
      sum.clear()
      this.#grid.visit(position, normal, this.#add)
      return
    }
    const held = this.#others.begin(sum, texel, position, normal)
    this.#grid.visit(position, normal, this.#add)
    this.#others.end(sum, held)
  }

  readonly #add: LineVisitor = (line, distance, segment, t, side) => {
    addStroke(this.#sum, this.#strokes[line], distance, segment, t, side, this.#sharpest)
  }
}
