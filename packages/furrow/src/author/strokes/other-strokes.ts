import type { Metric } from '../metric.ts'
import { addStroke, HeightSum, type StrokePowers, sharpestAt } from './height-sum.ts'
import { type LaidStroke, reachOf } from './lay-out.ts'
import { LineGrid, type LineVisitor } from './line-grid.ts'

/** Numbers that are held; when there are more, all are forgotten: 32 MB. */
const MOST_HELD = 2 ** 22
/** Numbers of a texel before those of the strokes behind the edited one, two of each: three of the sum, and how many follow. */
const HEAD = 4

/**
 * What all strokes but one give to texels, held from when it is first asked for: an artist bends one line, and those round it stay. Sums
 * of floating-point numbers depend on the order, so the strokes before the one are held as their sum, and each behind it on its own.
 */
export class OtherStrokes {
  readonly #strokes: readonly LaidStroke[]
  /** Index of the first stroke behind the one that is edited. */
  readonly #behind: number
  readonly #grid: LineGrid
  readonly #metric: Metric
  /** Where the numbers of each texel begin. */
  readonly #starts = new Map<number, number>()
  #numbers = new Float64Array(2 ** 14)
  #used = 0
  /** Of the texel that is held. */
  readonly #before = new HeightSum()
  readonly #after = new HeightSum()
  #sharpest = 0
  readonly #powers: StrokePowers = { valley: 0, bank: 0 }

  constructor(before: readonly LaidStroke[], behind: readonly LaidStroke[], metric: Metric) {
    this.#strokes = [...before, ...behind]
    this.#behind = before.length
    this.#grid = new LineGrid(this.#strokes, this.#strokes.map(reachOf))
    this.#metric = metric
  }

  /** Texels for which what the strokes give is held. */
  get held(): number {
    return this.#starts.size
  }

  /**
   * Begins the sum of a texel with the strokes before the edited one.
   *
   * @returns what `end` takes once the edited one is added.
   */
  begin(sum: HeightSum, texel: number, position: Float64Array, normal: Float64Array): number {
    const start = this.hold(texel, position, normal)
    sum.valleys = this.#numbers[start]
    sum.banks = this.#numbers[start + 1]
    sum.shade = this.#numbers[start + 2]
    return start
  }

  /** Adds the strokes behind the edited one. */
  end(sum: HeightSum, start: number): void {
    const first = start + HEAD
    const end = first + this.#numbers[start + HEAD - 1]
    for (let i = first; i < end; i += 2) sum.add(this.#numbers[i], this.#numbers[i + 1])
  }

  /**
   * Finds what the strokes give to a texel where that is not held yet.
   *
   * @returns where its numbers begin.
   */
  hold(texel: number, position: Float64Array, normal: Float64Array): number {
    const known = this.#starts.get(texel)
    if (known !== undefined) return known
    if (this.#used > MOST_HELD) {
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
    const isBehind = line >= this.#behind
    const sum = isBehind ? this.#after : this.#before
    addStroke(sum, this.#strokes[line], distance, segment, t, side, this.#sharpest, this.#powers)
    if (!isBehind) return
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
