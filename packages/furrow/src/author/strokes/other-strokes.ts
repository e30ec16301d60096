import type { Metric } from '../metric.ts'
import { addStroke, HeightSum, type StrokePowers, sharpestAt } from './height-sum.ts'
import { type LaidStroke, reachOf } from './lay-out.ts'
import { LineGrid, type LineVisitor } from './line-grid.ts'

/** Maximum count of cached numbers (32 MB); a full cache is emptied. */
const MAX_CACHED = 2 ** 22
/**
 * Length of a texel's header in the cache: `valleys`, `banks`, `bulges` and `shade` of a `HeightSum`, and the count of numbers after the header.
 */
const HEAD = 5
/** Count of numbers that the cache stores for each stroke after the edited one: `valley`, `bank` and `bulge`. They follow the header. */
const STRIDE = 3

/**
 * Caches, for each texel, the contributions of all strokes (wrinkles) except the one that an artist is editing. Contributions must be added
 * in the order of the strokes, because rounding depends on the order. The strokes before the edited one are therefore cached as one sum, and
 * the strokes after it one by one.
 */
export class OtherStrokes {
  readonly #strokes: readonly LaidStroke[]
  /** Index of the first stroke after the edited one. */
  readonly #firstAfter: number
  readonly #grid: LineGrid
  readonly #metric: Metric
  /** For each texel, the index of its header in `#numbers`. */
  readonly #starts = new Map<number, number>()
  #numbers = new Float64Array(2 ** 14)
  #used = 0
  /** Scratch sums, reused per texel. */
  readonly #before = new HeightSum()
  readonly #after = new HeightSum()
  #sharpest = 0
  readonly #powers: StrokePowers = { valley: 0, bank: 0, bulge: 0 }

  constructor(before: readonly LaidStroke[], after: readonly LaidStroke[], metric: Metric) {
    this.#strokes = [...before, ...after]
    this.#firstAfter = before.length
    this.#grid = new LineGrid(this.#strokes, this.#strokes.map(reachOf))
    this.#metric = metric
  }

  /** Number of cached texels. */
  get held(): number {
    return this.#starts.size
  }

  /**
   * Sets `sum` to the contributions of the strokes before the edited one, at one texel. `shade` also includes the strokes after the edited
   * one, because the maximum does not depend on the order.
   *
   * @returns number to pass to `end` after the edited stroke is added to the sum.
   */
  begin(sum: HeightSum, texel: number, position: Float64Array, normal: Float64Array): number {
    const start = this.hold(texel, position, normal)
    sum.valleys = this.#numbers[start]
    sum.banks = this.#numbers[start + 1]
    sum.bulges = this.#numbers[start + 2]
    sum.shade = this.#numbers[start + 3]
    return start
  }

  /** Adds the strokes after the edited one to the sum. */
  end(sum: HeightSum, start: number): void {
    const first = start + HEAD
    const end = first + this.#numbers[start + HEAD - 1]
    const powers = this.#powers
    for (let i = first; i < end; i += STRIDE) {
      powers.valley = this.#numbers[i]
      powers.bank = this.#numbers[i + 1]
      powers.bulge = this.#numbers[i + 2]
      sum.add(powers)
    }
  }

  /**
   * Caches the contributions of the other strokes to a texel, unless they are cached already.
   *
   * @returns index of the texel's header in `#numbers`.
   */
  hold(texel: number, position: Float64Array, normal: Float64Array): number {
    const known = this.#starts.get(texel)
    if (known !== undefined) return known
    if (this.#used > MAX_CACHED) {
      this.#starts.clear()
      this.#used = 0
    }
    const start = this.#used
    this.#starts.set(texel, start)
    this.#reserve(HEAD + STRIDE * this.#strokes.length)
    this.#used = start + HEAD
    this.#before.clear()
    this.#after.clear()
    this.#sharpest = sharpestAt(this.#metric, texel)
    this.#grid.visit(position, normal, this.#add)
    const { valleys, banks, bulges, shade } = this.#before
    const shades = Math.max(shade, this.#after.shade)
    this.#numbers.set([valleys, banks, bulges, shades, this.#used - start - HEAD], start)
    return start
  }

  readonly #add: LineVisitor = (line, distance, segment, t, side) => {
    const isAfter = line >= this.#firstAfter
    const sum = isAfter ? this.#after : this.#before
    addStroke(sum, this.#strokes[line], distance, segment, t, side, this.#sharpest, this.#powers)
    if (!isAfter) return
    this.#numbers[this.#used++] = this.#powers.valley
    this.#numbers[this.#used++] = this.#powers.bank
    this.#numbers[this.#used++] = this.#powers.bulge
  }

  #reserve(count: number): void {
    if (this.#used + count <= this.#numbers.length) return
    const larger = new Float64Array(2 * this.#numbers.length + count)
    larger.set(this.#numbers)
    this.#numbers = larger
  }
}
