import { weldVertices } from '../math/weld.ts'
import type { CoarseMesh } from './coarse-mesh.ts'
import { PairNumbers } from './pair-numbers.ts'

/** Halvings of an edge at most: 1 m into segments of 1 mm. */
export const MAX_LEVEL = 10

/** Texture coordinates of two edges, each u and v at one end and at the other. */
const PER_EDGE = 8

/**
 * The edges of the welded mesh, by number: those between the same two positions are one, whatever their texture coordinates. They begin at
 * the end whose first vertex comes first.
 */
export class WeldedEdges {
  /** By vertex: the first vertex at its position, which all of them follow. */
  readonly firstOf: Uint32Array
  /** The edge from each corner of each triangle to the next. */
  readonly edgeOf: Uint32Array
  /** How many edges there are. */
  readonly count: number
  readonly #lengths: Float64Array
  readonly #uvs: Float64Array
  /** The texture coordinates at hand. */
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

  /** Whether the edge between two vertices begins at `a`. */
  startsAt(a: number, b: number): boolean {
    return this.firstOf[a] < this.firstOf[b]
  }

  /**
   * One of the texture coordinates at a point of an edge: of two of the edges at a seam, the same two for all of them; otherwise twice the same.
   *
   * @param at 0..1, from where the edge begins.
   * @param k 0 and 1 for u and v of the one, 2 and 3 for those of the other.
   */
  uvAt(edge: number, at: number, k: number): number {
    const offset = PER_EDGE * edge + (k < 2 ? k : k + 2)
    return this.#uvs[offset] + at * (this.#uvs[offset + 2] - this.#uvs[offset])
  }

  /**
   * Halves edges as often as one of their triangles needs, but not those that are no longer than `longest`.
   *
   * @param halvings of each triangle's own edges.
   * @returns of each edge, into 2 to the power of how many segments it is cut.
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

  /** Keeps the smallest and largest texture coordinates of an edge, in lexicographic order. */
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

  /** Below 0 where the texture coordinates at hand come before those at some offset, above where they come after them. */
  #compare(offset: number): number {
    for (let k = 0; k < 4; k++) {
      const difference = this.#own[k] - this.#uvs[offset + k]
      if (difference !== 0) return difference
    }
    return 0
  }
}

/** The corner of the same triangle that follows. */
export function nextCorner(corner: number): number {
  return corner % 3 === 2 ? corner - 2 : corner + 1
}

/** Returns the first vertex at the position of each vertex. */
export function firstVertices(positions: ArrayLike<number>): Uint32Array {
  const { pointOf, count } = weldVertices(positions)
  const first = new Uint32Array(count)
  for (let vertex = pointOf.length - 1; vertex >= 0; vertex--) first[pointOf[vertex]] = vertex
  return pointOf.map((point) => first[point])
}

/** Halvings until segments are no longer than `longest`. */
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
