import { weldVertices } from '../math/weld.ts'
import type { CoarseMesh } from './coarse-mesh.ts'

/** An edge of the welded mesh: all edges between the same two positions, whatever their texture coordinates. */
export interface WeldedEdge {
  /** Metres at rest. */
  length: number
  /** It is cut into 2 to the power of this many segments. */
  level: number
  /**
   * Texture coordinates at both ends, from the one whose vertex is first: of two of the edges at a seam, the same two for all of them; otherwise
   * twice the same.
   */
  uvs: readonly [first: EdgeUvs, last: EdgeUvs]
}

/** u and v at one end and at the other. */
export type EdgeUvs = readonly [number, number, number, number]

/** The first vertex at each vertex's position, and the welded edges. */
export class WeldedEdges {
  /** Of each vertex the first one at its position: all of them move as that does. */
  readonly firstOf: Uint32Array
  readonly #edges = new Map<number, WeldedEdge>()
  readonly #mesh: CoarseMesh

  constructor(mesh: CoarseMesh) {
    this.#mesh = mesh
    const { pointOf, count } = weldVertices(mesh.positions)
    const first = new Uint32Array(count).fill(0xffffffff)
    for (const [vertex, point] of pointOf.entries()) first[point] = Math.min(first[point], vertex)
    this.firstOf = pointOf.map((point) => first[point])
    const { triangles } = mesh
    for (let k = 0; k + 2 < triangles.length; k += 3) {
      for (let corner = 0; corner < 3; corner++) {
        this.#add(triangles[k + corner], triangles[k + ((corner + 1) % 3)])
      }
    }
  }

  /** The edge between two vertices of a triangle. */
  between(a: number, b: number): WeldedEdge {
    return this.#edges.get(this.#key(a, b))!
  }

  /** Whether an edge's segments are counted from its vertex `a` on: they are from that whose position comes first. */
  startsAt(a: number, b: number): boolean {
    return this.firstOf[a] < this.firstOf[b]
  }

  get isAnyCut(): boolean {
    for (const { level } of this.#edges.values()) if (level > 0) return true
    return false
  }

  /** Cuts the edges of some triangles into segments no longer than `longest`; all others stay whole. */
  cut(covered: Uint8Array, longest: number): void {
    for (const edge of this.#edges.values()) edge.level = 0
    const { triangles } = this.#mesh
    for (let t = 0; t < covered.length; t++) {
      if (!covered[t]) continue
      for (let corner = 0; corner < 3; corner++) {
        const edge = this.between(triangles[3 * t + corner], triangles[3 * t + ((corner + 1) % 3)])
        edge.level = levelOf(edge.length, longest)
      }
    }
  }

  #add(a: number, b: number): void {
    const { positions, uvs } = this.#mesh
    const [from, to] = this.startsAt(a, b) ? [a, b] : [b, a]
    const own: EdgeUvs = [uvs[2 * from], uvs[2 * from + 1], uvs[2 * to], uvs[2 * to + 1]]
    const key = this.#key(a, b)
    const known = this.#edges.get(key)
    if (known) {
      const [first, last] = known.uvs
      known.uvs = [isBefore(own, first) ? own : first, isBefore(last, own) ? own : last]
      return
    }
    const length = Math.hypot(...[0, 1, 2].map((axis) => positions[3 * a + axis] - positions[3 * b + axis]))
    this.#edges.set(key, { length, level: 0, uvs: [own, own] })
  }

  #key(a: number, b: number): number {
    const [p, q] = [this.firstOf[a], this.firstOf[b]]
    return p < q ? p * this.firstOf.length + q : q * this.firstOf.length + p
  }
}

/** Halvings until segments are no longer than `longest`. */
function levelOf(length: number, longest: number): number {
  const level = Math.ceil(Math.log2(length / longest))
  return Number.isFinite(level) ? Math.min(Math.max(level, 0), MAX_LEVEL) : 0
}

/** Halvings of an edge at most: 1 m into segments of 1 mm. */
export const MAX_LEVEL = 10

/** An order of texture coordinates, whichever it is. */
function isBefore(a: EdgeUvs, b: EdgeUvs): boolean {
  const k = a.findIndex((value, i) => value !== b[i])
  return k >= 0 && a[k] < b[k]
}
