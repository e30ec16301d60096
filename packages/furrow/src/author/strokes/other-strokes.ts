import type { Metric } from '../metric.ts'
import { addStroke, HeightSum, type StrokePowers, sharpestAt } from './height-sum.ts'
import { type LaidStroke, reachOf } from './lay-out.ts'
import { LineGrid, type LineVisitor } from './line-grid.ts'

/** Maximum count of cached numbers (32 MB); a full cache is emptied. */
const MAX_CACHED = 2 ** 22
/**
 * Length of a texel's header: `valleys`, `banks` and `shade` of a sum, and the count of numbers that follow. Two numbers follow for each
 * stroke after the edited one.
 */
const HEAD = 4

/**
 * Caches what all strokes except the edited one contribute to each texel, because they do not change while an artist edits one stroke.
 * Strokes must be added in the order of the list, because rounding depends on the order. Strokes before the edited one are therefore cached
 * as one sum, and strokes after it one by one.
 */
export class OtherStrokes {
  readonly #strokes: readonly LaidStroke[]
  /** Index of the first stroke after the edited one. */
  readonly #firstAfter: number
  readonly #grid: LineGrid
  readonly #metric: Metric
  /** Index in `#numbers` of each texel's header. */
  readonly #starts = new Map<number, number>()
  #numbers = new Float64Array(2 ** 14)
  #used = 0
  /** Scratch sums, reused per texel. */
  readonly #before = new HeightSum()
  readonly #after = new HeightSum()
  #sharpest = 0
  readonly #powers: StrokePowers = { valley: 0, bank: 0 }

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
   * Starts the sum of a texel with the strokes before the edited one.
   *
   * @returns number to pass to `end` after the edited stroke is added.
   */
  begin(sum: HeightSum, texel: number, position: Float64Array, normal: Float64Array): number {
    const start = this.hold(texel, position, normal)
    sum.valleys = this.#numbers[start]
    sum.banks = this.#numbers[start + 1]
    sum.shade = this.#numbers[start + 2]
    return start
  }

  /** Adds the strokes after the edited one. */
  end(sum: HeightSum, start: number): void {
    const first = start + HEAD
    const end = first + this.#numbers[start + HEAD - 1]
    for (let i = first; i < end; i += 2) sum.add(this.#numbers[i], this.#numbers[i + 1])
  }

  /**
   * Caches the contributions of the other strokes to a texel, unless they are cached already.
   *
   * @returns index in `#numbers` of the texel's header.
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
    this.#reserve(HEAD + 2 * this.#strokes.length)
    this.#used = start + HEAD
    this.#before.clear()
    this.#after.clear()
    this.#sharpest = sharpestAt(this.#metric, texel)
    this.#grid.visit(position, normal, this.#add)
    const { valleys, banks, shade } = this.#before
    const shades = Math.max(shade, this.#after.shade)
    this.#numbers.set([valleys, banks, shades, this.#used - start - HEAD], start)
    return start
  }

  readonly #add: LineVisitor = (line, distance, segment, t, side) => {
    const isAfter = line >= this.#firstAfter
    const sum = isAfter ? this.#after : this.#before
    addStroke(sum, this.#strokes[line], distance, segment, t, side, this.#sharpest, this.#powers)
    if (!isAfter) return
    this.#numbers[this.#used++] = this.#powers.valley
    this.#numbers[this.#used++] = this.#powers.bank
  }

  #reserve(count: number): void {
    if (this.#used + count <= this.#numbers.length) return
    const larger = new Float64Array(2 * this.#numbers.length + count)
    larger.set(this.#numbers)
    this.#numbers = larger
  }
}
