/** Points of a leaf at most. */
const LEAF = 8

/** Finds the points nearest to a position, in two or three dimensions (Bentley 1975). */
export class KdTree {
  readonly #points: ArrayLike<number>
  readonly #dimensions: number
  /** Points in the order of the leaves: each range is split at its middle. */
  readonly #order: Uint32Array
  /** Coordinate at which a range is split, by the index of its middle. */
  readonly #splits: Float64Array
  readonly #found: Int32Array
  readonly #squares: Float64Array
  #count = 0

  /**
   * @param points coordinates of each point, one after the other. They are kept.
   * @param dimensions coordinates of a point.
   * @param most points that a query finds at most.
   */
  constructor(points: ArrayLike<number>, dimensions: number, most = 1) {
    this.#points = points
    this.#dimensions = dimensions
    this.#order = Uint32Array.from({ length: Math.floor(points.length / dimensions) }, (_, i) => i)
    this.#splits = new Float64Array(this.#order.length)
    this.#found = new Int32Array(most)
    this.#squares = new Float64Array(most)
    this.#sort(0, this.#order.length, 0)
  }

  /**
   * Finds the nearest points, the nearest first. The results are overwritten by the next query.
   *
   * @param query array that holds the position.
   * @param offset index of its first coordinate.
   * @param limit distance beyond which points are ignored.
   */
  nearest(
    query: ArrayLike<number>,
    offset = 0,
    limit = Infinity,
  ): { count: number; indices: Int32Array; squares: Float64Array } {
    this.#count = 0
    this.#squares.fill(Infinity)
    this.#search(query, offset, 0, this.#order.length, 0, limit * limit)
    return { count: this.#count, indices: this.#found, squares: this.#squares }
  }

  /** Visits the points within a distance, in the order of the tree. */
  within(query: ArrayLike<number>, offset: number, limit: number, visit: (index: number) => void): void {
    this.#visit(query, offset, 0, this.#order.length, 0, limit, visit)
  }

  #visit(
    query: ArrayLike<number>,
    offset: number,
    from: number,
    to: number,
    axis: number,
    limit: number,
    visit: (index: number) => void,
  ): void {
    if (to - from <= LEAF) {
      for (let k = from; k < to; k++)
        if (this.#squareTo(query, offset, this.#order[k]) <= limit * limit) visit(this.#order[k])
      return
    }
    const middle = (from + to) >> 1
    const ahead = query[offset + axis] - this.#splits[middle]
    const next = (axis + 1) % this.#dimensions
    if (ahead <= limit) this.#visit(query, offset, from, middle, next, limit, visit)
    if (ahead >= -limit) this.#visit(query, offset, middle, to, next, limit, visit)
  }

  #squareTo(query: ArrayLike<number>, offset: number, index: number): number {
    let square = 0
    for (let d = 0; d < this.#dimensions; d++)
      square += (this.#points[index * this.#dimensions + d] - query[offset + d]) ** 2
    return square
  }

  #search(
    query: ArrayLike<number>,
    offset: number,
    from: number,
    to: number,
    axis: number,
    limit: number,
  ): void {
    if (to - from <= LEAF) {
      for (let k = from; k < to; k++) this.#offer(query, offset, this.#order[k], limit)
      return
    }
    const middle = (from + to) >> 1
    const next = (axis + 1) % this.#dimensions
    const ahead = query[offset + axis] - this.#splits[middle]
    if (ahead < 0) this.#search(query, offset, from, middle, next, limit)
    else this.#search(query, offset, middle, to, next, limit)
    if (ahead * ahead > Math.min(limit, this.#squares[this.#squares.length - 1])) return
    if (ahead < 0) this.#search(query, offset, middle, to, next, limit)
    else this.#search(query, offset, from, middle, next, limit)
  }

  #offer(query: ArrayLike<number>, offset: number, index: number, limit: number): void {
    const square = this.#squareTo(query, offset, index)
    const last = this.#squares.length - 1
    if (!(square <= limit && square < this.#squares[last])) return
    let place = Math.min(this.#count, last)
    for (; place > 0 && this.#squares[place - 1] > square; place--) {
      this.#squares[place] = this.#squares[place - 1]
      this.#found[place] = this.#found[place - 1]
    }
    this.#squares[place] = square
    this.#found[place] = index
    if (this.#count <= last) this.#count++
  }

  /** Splits a range at its middle, and its halves (quickselect by Hoare). */
  #sort(from: number, to: number, axis: number): void {
    if (to - from <= LEAF) return
    const order = this.#order
    const middle = (from + to) >> 1
    const key = (k: number) => this.#points[order[k] * this.#dimensions + axis]
    let [low, high] = [from, to - 1]
    while (low < high) {
      const pivot = key((low + high) >> 1)
      let [i, j] = [low, high]
      while (i <= j) {
        while (key(i) < pivot) i++
        while (key(j) > pivot) j--
        if (i > j) break
        const swapped = order[i]
        order[i++] = order[j]
        order[j--] = swapped
      }
      if (middle <= j) high = j
      else if (middle >= i) low = i
      else break
    }
    this.#splits[middle] = key(middle)
    const next = (axis + 1) % this.#dimensions
    this.#sort(from, middle, next)
    this.#sort(middle, to, next)
  }
}
