import type { GrayImage } from '../../core/types.ts'
import { lerp } from '../../math/scalar.ts'
import type { SkinCanvas } from '../skin/canvas.ts'
import type { Stroke } from './document.ts'
import { isBulge, type LaidStroke, layOutStrokes, reachOf } from './lay-out.ts'
import { LineGrid, type LineVisitor } from './line-grid.ts'

/** Onset at the deepest point of a group of strokes. The onset is the influence, 0..1, at which a texel begins to wrinkle. */
const ONSET_OF_DEEPEST = 0.04

/**
 * Onset where the depth of a stroke reaches 0. It is not 0.5, because 0.5 is 127.5 as a byte, and rounding errors would decide between 127
 * and 128.
 */
const ONSET_OF_ENDS = 128 / 255

/**
 * Constant added to a stroke's relative depth. The sum is the stroke's weight in the mean onset of overlapping strokes. With the constant, the
 * weight is above 0 even at the ends of a stroke, where the depth is 0.
 */
const LEAST_WEIGHT = 0.02

/**
 * Whether a layer with these strokes gets an onset map. Bulges should rise in proportion to their influence. An onset map makes the rise
 * nonlinear, even at onset 0, so a layer with bulges gets none.
 */
export function hasOnset(strokes: readonly Pick<Stroke, 'depth'>[]): boolean {
  return strokes.length > 0 && !strokes.some(isBulge)
}

/**
 * Draws the onset map of strokes (wrinkles): the influence at which each texel begins to wrinkle. The deepest wrinkles appear first, so the
 * onset depends on the depth of the line relative to the deepest point of its group. It is constant across the width of a line. Bulges are
 * left out, so that a bulge rises along its whole length at the same time.
 *
 * @param strokes strokes of one layer. Strokes with the same `group` are compared with each other.
 * @returns a map with the size of the canvas: 255 = full influence, 0 outside the reach of all strokes.
 * @throws FurrowError if the strokes are longer than 100 m in total.
 */
export function strokesToOnset(strokes: readonly Stroke[], canvas: SkinCanvas): GrayImage {
  const valleys = strokes.filter((stroke) => !isBulge(stroke))
  const grouped = layOutStrokes(valleys, canvas).map((lines, i) => ({ group: valleys[i].group, lines }))
  const deepest = deepestByGroup(grouped)
  return drawLines(
    grouped.flatMap(({ group, lines }) => onsetLines(lines, deepest.get(group) ?? 0)),
    canvas,
  )
}

/**
 * Draws the onset map of strokes that `layOutStrokes` has laid on the skin. See `strokesToOnset`.
 *
 * @param groups strokes without bulges, by group. Depths are relative to the deepest point of the group.
 */
export function drawOnset(
  groups: readonly (readonly LaidStroke[])[],
  canvas: Pick<SkinCanvas, 'texels'>,
): GrayImage {
  return drawLines(
    groups.flatMap((lines) => onsetLines(lines, deepestOf(lines))),
    canvas,
  )
}

function drawLines(lines: readonly OnsetLine[], { texels }: Pick<SkinCanvas, 'texels'>): GrayImage {
  const { width, height } = texels
  const map = { width, height, data: new Uint8Array(width * height) }
  const pen = new OnsetPen(lines, map)
  texels.visitNear(pen.isNear, (texel, position, normal) => {
    if (pen.begins(texel)) pen.draw(texel, position, normal)
  })
  return map
}

/** Line with its depths relative to the deepest point of its group, 0..1. */
export interface OnsetLine {
  line: LaidStroke
  depths: Float64Array
}

/** Returns the depth of the deepest point of each group in millimetres. The keys are names of groups. */
export function deepestByGroup(
  strokes: readonly { group: string | undefined; lines: readonly LaidStroke[] }[],
): Map<string | undefined, number> {
  const deepest = new Map<string | undefined, number>()
  for (const { group, lines } of strokes)
    deepest.set(group, Math.max(deepest.get(group) ?? 0, deepestOf(lines)))
  return deepest
}

function deepestOf(lines: readonly LaidStroke[]): number {
  return lines.reduce((largest, { depths }) => depths.reduce((a, b) => Math.max(a, b), largest), 0)
}

/** @param deepest depth of the deepest point of the lines' group. */
export function onsetLines(lines: readonly LaidStroke[], deepest: number): OnsetLine[] {
  return lines.map((line) => ({
    line,
    depths: line.depths.map((depth) => (deepest > 0 ? depth / deepest : 1)),
  }))
}

/**
 * Draws an onset map by blocks of 2 x 2 texels. Onset varies slowly, so one value per block is enough. This saves three quarters of the time.
 * The value is that of the block's first texel with skin.
 */
export class OnsetPen {
  /** Returns whether a line may reach into a box, given by its lowest and highest x, y and z in millimetres. */
  readonly isNear: LineGrid['isNear']
  readonly #lines: readonly OnsetLine[]
  readonly #reaches: readonly number[]
  readonly #grid: LineGrid
  readonly #map: GrayImage
  /** For each block: 1 if one of its texels was passed to `begins`. */
  readonly #begun: Uint8Array
  #sum = 0
  #total = 0

  /** @param map receives the onset. */
  constructor(lines: readonly OnsetLine[], map: GrayImage) {
    const laid = lines.map(({ line }) => line)
    this.#lines = lines
    this.#reaches = laid.map(reachOf)
    this.#grid = new LineGrid(laid, this.#reaches)
    this.#map = map
    this.#begun = new Uint8Array(Math.ceil(map.width / 2) * Math.ceil(map.height / 2))
    this.isNear = this.#grid.isNear
  }

  /** Returns whether a texel is the first one of its block that is passed to this method. */
  begins(texel: number): boolean {
    const { width } = this.#map
    const block = ((texel % width) >> 1) + Math.ceil(width / 2) * (Math.floor(texel / width) >> 1)
    if (this.#begun[block]) return false
    this.#begun[block] = 1
    return true
  }

  /**
   * Draws the block of a texel.
   *
   * @param position position of the texel on the skin.
   * @param normal normal of the skin at the position.
   * @returns whether the value of `texel` changed. The whole block then has the new value.
   */
  draw(texel: number, position: Float64Array, normal: Float64Array): boolean {
    const { width, height, data } = this.#map
    this.#sum = this.#total = 0
    this.#grid.visit(position, normal, this.#add)
    const onset = this.#total === 0 ? 0 : Math.round((255 * this.#sum) / this.#total)
    if (data[texel] === onset) return false
    const [x, y] = [(texel % width) & ~1, Math.floor(texel / width) & ~1]
    for (let row = y; row < Math.min(height, y + 2); row++) {
      for (let column = x; column < Math.min(width, x + 2); column++) data[column + row * width] = onset
    }
    return true
  }

  readonly #add: LineVisitor = (line, distance, segment, t) => {
    const { depths } = this.#lines[line]
    const depth = lerp(depths[segment], depths[segment + 1], t)
    const weight = (depth + LEAST_WEIGHT) * (1 - distance / this.#reaches[line]) ** 2
    this.#sum += weight * lerp(ONSET_OF_ENDS, ONSET_OF_DEEPEST, depth)
    this.#total += weight
  }
}
