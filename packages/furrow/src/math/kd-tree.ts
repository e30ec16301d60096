/** Maximum number of points in a leaf. */
const LEAF = 8

/** k-d tree that finds the points nearest to a position in 2D or 3D (Bentley 1975). */
export class KdTree {
  readonly #points: ArrayLike<number>
  readonly #dimensions: number
  /** Indices of all points. A node of the tree is a range of this array. Its two children are the halves of the range. */
  readonly #order: Uint32Array
  /** Coordinate at which each node is split, stored at the middle index of the node's range. */
  readonly #splits: Float64Array
  readonly #found: Int32Array
  readonly #squares: Float64Array
  #count = 0
  /** Squared search radius. */
  #reach = Infinity

  /**
   * @param points packed coordinates. The array is not copied.
   * @param dimensions number of coordinates per point, 2 or 3.
   * @param most maximum number of points that a query finds.
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
   * Finds the nearest points, sorted by distance. The returned arrays are overwritten by the next query.
   *
   * @param query array with the coordinates of the query position.
   * @param offset index of the first coordinate in `query`.
   * @param limit maximum distance.
   * @returns number of found points, their indices, and their squared distances.
   */
  nearest(
    query: ArrayLike<number>,
    offset = 0,
    limit = Infinity,
  ): { count: number; indices: Int32Array; squares: Float64Array } {
    this.#count = 0
    this.#squares.fill(Infinity)
    this.#reach = limit * limit
    this.#walk(query, offset, 0, this.#order.length, 0, this.#offer)
    return { count: this.#count, indices: this.#found, squares: this.#squares }
  }

  /** Calls `visit` for all points within the distance `limit`, in any order. */
  within(query: ArrayLike<number>, offset: number, limit: number, visit: (index: number) => void): void {
    this.#reach = limit * limit
    this.#walk(query, offset, 0, this.#order.length, 0, visit)
  }

  /** Visits the points of a node that lie within the search radius. Starts with the child that contains the query position. */
  #walk(
    query: ArrayLike<number>,
    offset: number,
    from: number,
    to: number,
    axis: number,
    visit: (index: number, square: number) => void,
  ): void {
    if (to - from <= LEAF) {
      for (let k = from; k < to; k++) {
        const index = this.#order[k]
        let square = 0
        for (let d = 0; d < this.#dimensions; d++)
          square += (this.#points[index * this.#dimensions + d] - query[offset + d]) ** 2
        if (square <= this.#reach) visit(index, square)
      }
      return
    }
    const middle = (from + to) >> 1
    const next = (axis + 1) % this.#dimensions
    const ahead = query[offset + axis] - this.#splits[middle]
    if (ahead < 0) this.#walk(query, offset, from, middle, next, visit)
    else this.#walk(query, offset, middle, to, next, visit)
    if (ahead * ahead > this.#reach) return
    if (ahead < 0) this.#walk(query, offset, middle, to, next, visit)
    else this.#walk(query, offset, from, middle, next, visit)
  }

  /** Inserts a point into the results. Once the results are full, the farthest result limits the search radius. */
  readonly #offer = (index: number, square: number): void => {
    const last = this.#squares.length - 1
    if (!(square < this.#squares[last])) return
    let place = Math.min(this.#count, last)
    for (; place > 0 && this.#squares[place - 1] > square; place--) {
      this.#squares[place] = this.#squares[place - 1]
      this.#found[place] = this.#found[place - 1]
    }
    this.#squares[place] = square
    this.#found[place] = index
    if (this.#count <= last) this.#count++
    this.#reach = Math.min(this.#reach, this.#squares[last])
  }

  /**
   * Partitions a range at its middle by the coordinate `axis` (quickselect, Hoare 1961): no point before the middle has a larger coordinate
   * than a point after it. Then partitions both halves by the next coordinate.
   */
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
