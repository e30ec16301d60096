import { weldVertices } from '../math/weld.ts'
import type { CoarseMesh } from './coarse-mesh.ts'
import { PairNumbers } from './pair-numbers.ts'

/** Maximum number of halvings of an edge. Ten halvings split an edge of 1 m into parts of 1 mm. */
export const MAX_LEVEL = 10

/** Number of texture coordinates per welded edge: u and v at both ends, for two mesh edges. */
const PER_EDGE = 8

/**
 * Assigns numbers to the edges of a mesh. Edges between the same two positions count as one welded edge, even if their texture coordinates
 * differ. A welded edge starts at the vertex with the smaller value in `firstOf`.
 */
export class WeldedEdges {
  /** Maps each vertex to the first vertex at the same position. */
  readonly firstOf: Uint32Array
  /** For each triangle corner, the number of the welded edge from this corner to the next. */
  readonly edgeOf: Uint32Array
  /** Number of welded edges. */
  readonly count: number
  readonly #lengths: Float64Array
  readonly #uvs: Float64Array
  /** Scratch array with the texture coordinates at both ends of an edge. */
  readonly #own = new Float64Array(4)

  constructor({ positions, uvs, triangles }: CoarseMesh) {
    this.firstOf = firstVertices(positions)
    const { firstOf } = this
    const corners = triangles.length - (triangles.length % 3)
    this.edgeOf = new Uint32Array(corners)
    this.#lengths = new Float64Array(corners)
    this.#uvs = new Float64Array(PER_EDGE * corners)
    const known = new PairNumbers(corners)
    for (let corner = 0; corner < corners; corner++) {
      const a = triangles[corner]
      const b = triangles[nextCorner(corner)]
      const isForward = this.startsAt(a, b)
      const from = isForward ? a : b
      const to = isForward ? b : a
      const { count } = known
      const edge = known.numberOf(firstOf[from], firstOf[to])
      this.edgeOf[corner] = edge
      if (edge === count) this.#lengths[edge] = distance(positions, a, b)
      this.#addUvs(uvs, edge, from, to, edge === count)
    }
    this.count = known.count
  }

  /** Whether vertex `a` is the start of the welded edge between `a` and `b`. */
  startsAt(a: number, b: number): boolean {
    return this.firstOf[a] < this.firstOf[b]
  }

  /**
   * Interpolates the texture coordinates at a point of a welded edge. There are two pairs of coordinates, which differ at a texture seam.
   *
   * @param at position along the edge, from 0 at its start to 1.
   * @param k coordinate to return: 0 and 1 are u and v of the first pair, 2 and 3 are u and v of the second pair.
   */
  uvAt(edge: number, at: number, k: number): number {
    const offset = PER_EDGE * edge + (k < 2 ? k : k + 2)
    return this.#uvs[offset] + at * (this.#uvs[offset + 2] - this.#uvs[offset])
  }

  /**
   * Computes the number of halvings of each welded edge. It is the maximum over the triangles at the edge, but halving stops when the parts of
   * the edge are at most `longest` metres long.
   *
   * @param halvings number of halvings for the edges of each triangle; may be fractional.
   * @returns an integer for each welded edge. The edge is split into `2 ** halvings` parts.
   */
  levelsFor(halvings: Float32Array, longest: number): Uint8Array {
    const levels = new Uint8Array(this.count)
    for (let corner = 0; corner < this.edgeOf.length; corner++) {
      const needed = Math.ceil(halvings[corner])
      const edge = this.edgeOf[corner]
      if (needed > levels[edge]) levels[edge] = Math.min(needed, levelOf(this.#lengths[edge], longest))
    }
    return levels
  }

  /** Stores the texture coordinates of an edge if they are the smallest or largest of their welded edge, in lexicographic order. */
  #addUvs(uvs: ArrayLike<number>, edge: number, from: number, to: number, isNew: boolean): void {
    const own = this.#own
    own[0] = uvs[2 * from]
    own[1] = uvs[2 * from + 1]
    own[2] = uvs[2 * to]
    own[3] = uvs[2 * to + 1]
    const first = PER_EDGE * edge
    const last = first + 4
    if (isNew || this.#compare(first) < 0) this.#uvs.set(own, first)
    if (isNew || this.#compare(last) > 0) this.#uvs.set(own, last)
  }

  /** Compares `#own` with the coordinates at an offset of `#uvs`, in lexicographic order. The result is negative if `#own` is smaller. */
  #compare(offset: number): number {
    for (let k = 0; k < 4; k++) {
      const difference = this.#own[k] - this.#uvs[offset + k]
      if (difference !== 0) return difference
    }
    return 0
  }
}

/** Returns the next corner of the same triangle. */
export function nextCorner(corner: number): number {
  return corner % 3 === 2 ? corner - 2 : corner + 1
}

/** Returns, for each vertex, the index of the first vertex at the same position. */
export function firstVertices(positions: ArrayLike<number>): Uint32Array {
  const { pointOf, count } = weldVertices(positions)
  const first = new Uint32Array(count)
  for (let vertex = pointOf.length - 1; vertex >= 0; vertex--) first[pointOf[vertex]] = vertex
  return pointOf.map((point) => first[point])
}

/** Returns the number of halvings after which the parts of an edge are at most `longest` metres long. */
function levelOf(length: number, longest: number): number {
  const level = Math.ceil(Math.log2(length / longest))
  return Number.isFinite(level) ? Math.min(Math.max(level, 0), MAX_LEVEL) : 0
}

function distance(positions: ArrayLike<number>, a: number, b: number): number {
  const x = positions[3 * a] - positions[3 * b]
  const y = positions[3 * a + 1] - positions[3 * b + 1]
  const z = positions[3 * a + 2] - positions[3 * b + 2]
  return Math.sqrt(x * x + y * y + z * z)
}
