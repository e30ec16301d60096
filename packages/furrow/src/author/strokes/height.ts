import type { GrayImage } from '../../core/types.ts'
import { lerp } from '../../math/scalar.ts'
import type { Metric } from '../metric.ts'
import type { SkinCanvas } from '../skin/canvas.ts'
import type { Stroke } from './document.ts'
import { type LaidStroke, layOutStrokes } from './lay-out.ts'
import { LineGrid, type LineVisitor } from './line-grid.ts'
import { profile, REACH } from './profile.ts'

/** Relief of the skin. */
export interface HeightMap {
  width: number
  height: number
  /** Millimetres above (+) or below (-) the smooth skin, width x height values, row 0 is v = 0. */
  data: Float32Array
}

/** The relief of strokes, and how open to the light it is. */
export interface DrawnStrokes {
  relief: HeightMap
  /** 255 = open. */
  occlusion: GrayImage
}

/**
 * Exponent of the smooth maximum that joins strokes: (a^6 + b^6)^(1/6) is the larger of two, at most 12% more where they are
 * equal. Valleys that cross are as deep as the deeper one, not as both together.
 */
const JOIN = 6
/** Fraction of the light that a valley loses, per depth in half widths, and at most. */
const SHADE = 1.1
const MAX_SHADE = 0.75

/**
 * Draws strokes as a height map. Distances are measured in space, so that neither the texture's stretch nor its seams show. Valleys are joined
 * with valleys and banks with banks (see JOIN), then added, so the order of the strokes does not matter and a single stroke keeps its exact
 * profile. No valley is drawn sharper than a texel. Strokes, or parts of them, that are not on the skin are left out.
 *
 * @param progress is called with the strokes drawn so far: all of them in the part of the map that is done.
 * @throws FurrowError where they are longer than 100 m together.
 */
export function strokesToHeight(
  strokes: readonly Stroke[],
  canvas: SkinCanvas,
  progress?: (done: number, total: number) => void,
): HeightMap {
  const laid = layOutStrokes(strokes, canvas).flat()
  return drawStrokes(laid, canvas, (fraction) => progress?.(fraction * strokes.length, strokes.length)).relief
}

/** Draws strokes that are laid on the skin already. */
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

/** The maps of skin without strokes. */
export function flatSkin(width: number, height: number): DrawnStrokes {
  const texels = width * height
  return {
    relief: { width, height, data: new Float32Array(texels) },
    occlusion: { width, height, data: new Uint8Array(texels).fill(255) },
  }
}

/** How far from its middle a stroke is drawn, in millimetres. */
export function reachOf({ halfWidths }: LaidStroke): number {
  return REACH * halfWidths.reduce((a, b) => Math.max(a, b), 0)
}

/** Draws strokes texel by texel: what a texel gets depends on the strokes within reach of it, and on nothing else. */
export class StrokePen {
  /** Whether strokes may be within reach of a box, given by its lowest and highest x, y and z. */
  readonly isNear: LineGrid['isNear']
  readonly #strokes: readonly LaidStroke[]
  readonly #grid: LineGrid
  readonly #metric: Metric
  readonly #drawn: DrawnStrokes
  /** Half the size of the texel that is drawn, in millimetres; sums of powers of its heights; its darkest shade. */
  #sharpest = 0
  #valleys = 0
  #banks = 0
  #shade = 0

  /** @param drawn takes what is drawn. */
  constructor(strokes: readonly LaidStroke[], metric: Metric, drawn: DrawnStrokes) {
    this.#strokes = strokes
    this.#grid = new LineGrid(strokes, strokes.map(reachOf))
    this.#metric = metric
    this.#drawn = drawn
    this.isNear = this.#grid.isNear
  }

  /**
   * Draws a texel.
   *
   * @param position of the texel on the skin.
   * @param normal of the skin there.
   * @returns whether it is another than before.
   */
  draw(texel: number, position: Float64Array, normal: Float64Array): boolean {
    const { relief, occlusion } = this.#drawn
    this.#sharpest = texelSize(this.#metric, texel) / 2
    this.#valleys = this.#banks = this.#shade = 0
    this.#grid.visit(position, normal, this.#add)
    const height = Math.fround(this.#banks ** (1 / JOIN) - this.#valleys ** (1 / JOIN))
    const open = Math.round(255 * (1 - Math.min(MAX_SHADE, Math.fround(this.#shade))))
    if (relief.data[texel] === height && occlusion.data[texel] === open) return false
    relief.data[texel] = height
    occlusion.data[texel] = open
    return true
  }

  readonly #add: LineVisitor = (line, distance, segment, t, side) => {
    const { depths, halfWidths, shoulder, softness } = this.#strokes[line]
    const depth = lerp(depths[segment], depths[segment + 1], t)
    const halfWidth = lerp(halfWidths[segment], halfWidths[segment + 1], t)
    if (depth === 0) return
    const raised = lerp(shoulder[0], shoulder[1], 0.5 + 0.5 * side)
    const roundness = Math.max(softness, this.#sharpest / halfWidth)
    const height = depth * profile(distance / halfWidth, raised, roundness)
    if (height < 0) {
      this.#valleys += powerOf(height)
      this.#shade = Math.max(this.#shade, (-height / halfWidth) * SHADE)
    } else this.#banks += powerOf(height)
  }
}

/** A height to the power of JOIN. */
function powerOf(height: number): number {
  const square = height * height
  return square * square * square
}

/** The longer side of a texel in millimetres. */
function texelSize({ uu, vv, width, height }: Metric, texel: number): number {
  return Math.sqrt(Math.max(uu[texel] / width ** 2, vv[texel] / height ** 2))
}
