import { powerOfTwoFrom } from '../../math/scalar.ts'

/** Spatial hash of positions: a grid of cubes in which only occupied cubes use memory. */
export class SeedGrid {
  readonly #positions: Float64Array
  readonly #side: number
  readonly #mask: number
  /** Index of the position last added to each bucket; -1 if none. */
  readonly #last: Int32Array
  /** For each position, the index of the previous position in the same bucket; -1 if none. */
  readonly #before: Int32Array
  /** Grid coordinates of each position, packed. */
  readonly #cells: Int32Array
  readonly #found: Int32Array

  /**
   * @param positions packed xyz of all positions that may be added. A position must not change after it is added.
   * @param side edge length of a cube.
   */
  constructor(positions: Float64Array, side: number) {
    const count = positions.length / 3
    this.#positions = positions
    this.#side = side
    this.#mask = powerOfTwoFrom(count + 1) - 1
    this.#last = new Int32Array(this.#mask + 1).fill(-1)
    this.#before = new Int32Array(count)
    this.#cells = new Int32Array(3 * count)
    this.#found = new Int32Array(count)
  }

  add(index: number): void {
    const first = 3 * index
    for (let k = first; k < first + 3; k++) this.#cells[k] = Math.floor(this.#positions[k] / this.#side)
    const bucket = this.#bucket(this.#cells[first], this.#cells[first + 1], this.#cells[first + 2])
    this.#before[index] = this.#last[bucket]
    this.#last[bucket] = index
  }

  /**
   * Returns the added positions in all cubes that a box touches.
   *
   * @param reach distance by which the box is expanded.
   * @returns indices of the positions. The array is valid until the next search.
   */
  search(low: ArrayLike<number>, high: ArrayLike<number>, reach: number): Int32Array {
    const [cells, found] = [this.#cells, this.#found]
    const from = (k: number) => Math.floor((low[k] - reach) / this.#side)
    const to = (k: number) => Math.floor((high[k] + reach) / this.#side)
    const [j0, k0, i1, j1, k1] = [from(1), from(2), to(0), to(1), to(2)]
    let count = 0
    for (let i = from(0); i <= i1; i++) {
      for (let j = j0; j <= j1; j++) {
        for (let k = k0; k <= k1; k++) {
          for (let n = this.#last[this.#bucket(i, j, k)]; n >= 0; n = this.#before[n]) {
            // Several cubes can share a bucket.
            if (cells[3 * n] === i && cells[3 * n + 1] === j && cells[3 * n + 2] === k) found[count++] = n
          }
        }
      }
    }
    return found.subarray(0, count)
  }

  #bucket(i: number, j: number, k: number): number {
    return (Math.imul(i, 0x8da6b343) ^ Math.imul(j, 0xd8163841) ^ Math.imul(k, 0xcb1ab31f)) & this.#mask
  }
}
