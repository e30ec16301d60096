import type { CoarseMesh } from './coarse-mesh.ts'
import { type DenseMesh, DenseVertices } from './dense-mesh.ts'
import { splitPatch, WHOLE } from './patch.ts'
import { WeldedEdges } from './welded-edges.ts'

export interface SplitOptions {
  /** Length that edges have after splitting, about, in metres. */
  edge?: number
  /** Triangles at most; edges become longer instead. */
  budget?: number
}

export const SPLIT_DEFAULTS: Required<SplitOptions> = { edge: 0.0012, budget: 100_000 }

/** Halved edges are between 0.7 and 1.4 of the length that is aimed at. */
const LONGEST = Math.SQRT2

/** Triangles of the coarse mesh in one slice. */
const SLICE = 256

/**
 * Splits the triangles under areas into patches, and joins all others to them without T-junctions.
 *
 * @param covered 1 for each triangle that is split, see `coveredTriangles`.
 * @returns a generator, so that a page may spread the work over frames.
 */
export function* splitMesh(
  mesh: CoarseMesh,
  covered: Uint8Array,
  options: SplitOptions = {},
): Generator<void, DenseMesh> {
  const { edge: wanted, budget } = { ...SPLIT_DEFAULTS, ...options }
  const edges = new WeldedEdges(mesh)
  yield
  const edge = fitBudget(mesh, covered, edges, wanted, budget)
  yield
  const splitter = new Splitter(mesh, edges, LONGEST * edge)
  for (let t = 0; t < covered.length; t++) {
    splitter.split(t, covered[t] > 0)
    if (t % SLICE === SLICE - 1) yield
  }
  const { vertices, triangles } = splitter
  return {
    count: vertices.count,
    triangles: Uint32Array.from(triangles),
    parents: Uint32Array.from(vertices.parents),
    corners: Uint32Array.from(vertices.corners),
    weights: Float32Array.from(vertices.weights),
    uvs: Float32Array.from(vertices.uvs),
    edge,
  }
}

/** Cuts edges so that there are no more triangles than allowed. Returns the length aimed at. */
function fitBudget(
  mesh: CoarseMesh,
  covered: Uint8Array,
  edges: WeldedEdges,
  wanted: number,
  budget: number,
): number {
  for (let edge = wanted; ; ) {
    edges.cut(covered, LONGEST * edge)
    const count = countTriangles(mesh, edges, covered.length)
    if (count <= budget || !edges.isAnyCut) return edge
    edge *= Math.max(1.05, Math.sqrt(count / budget))
  }
}

/** About how many triangles there will be: each halving of all three edges makes four of one. */
function countTriangles({ triangles }: CoarseMesh, edges: WeldedEdges, count: number): number {
  let sum = 0
  for (let t = 0; t < count; t++) {
    const levels = levelsOf(triangles, t, edges)
    sum += 2 ** ((2 * (levels[0] + levels[1] + levels[2])) / 3)
  }
  return sum
}

function levelsOf(triangles: ArrayLike<number>, t: number, edges: WeldedEdges): [number, number, number] {
  const [a, b, c] = [triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]]
  return [edges.between(a, b).level, edges.between(b, c).level, edges.between(c, a).level]
}

/** Splits triangles one by one. Those that have an edge in common have its vertices in common too. */
class Splitter {
  readonly vertices: DenseVertices
  readonly triangles: number[] = []
  readonly #mesh: CoarseMesh
  readonly #edges: WeldedEdges
  readonly #longest: number
  /** The first vertex on each edge that is cut, by the edge's two vertices. */
  readonly #onEdges = new Map<number, number>()

  constructor(mesh: CoarseMesh, edges: WeldedEdges, longest: number) {
    this.#mesh = mesh
    this.#edges = edges
    this.#longest = longest
    this.vertices = new DenseVertices(edges.firstOf)
    const uvs = uvsOfPoints(mesh, edges.firstOf)
    for (let i = 0; i < edges.firstOf.length; i++)
      this.vertices.add([i, i, i], [1, 0, 0], uvs[edges.firstOf[i]])
  }

  split(t: number, isCovered: boolean): void {
    const { triangles, uvs } = this.#mesh
    const corners = [triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]] as const
    const levels = levelsOf(triangles, t, this.#edges)
    const emit = (a: number, b: number, c: number) => {
      this.triangles.push(a, b, c)
    }
    if (Math.max(...levels) === 0) {
      emit(...corners)
      return
    }
    const [a, b, c] = corners
    const squared = squaredLengths(this.#mesh.positions, corners)
    const limit = (this.#longest * WHOLE) ** 2
    splitPatch(
      {
        corners,
        levels,
        isLong: (dx, dy) => isCovered && squared(dx, dy) > limit,
        onEdge: (edge, part) => this.#onEdge(corners[edge], corners[(edge + 1) % 3], part),
        inside: (x, y) => {
          const weights = [x / WHOLE, y / WHOLE, (WHOLE - x - y) / WHOLE] as const
          const [u, v] = [0, 1].map(
            (k) => weights[0] * uvs[2 * a + k] + weights[1] * uvs[2 * b + k] + weights[2] * uvs[2 * c + k],
          )
          return this.vertices.add(corners, weights, [u, v, u, v])
        },
      },
      emit,
    )
  }

  /** The vertex at some part, 0..1, of the edge from `a` to `b`. */
  #onEdge(a: number, b: number, part: number): number {
    const [from, to, t] = this.#edges.startsAt(a, b) ? [a, b, part] : [b, a, 1 - part]
    const { level, uvs } = this.#edges.between(a, b)
    const segments = 2 ** level
    const key = from * this.#edges.firstOf.length + to
    const known = this.#onEdges.get(key)
    const first = known ?? this.vertices.count
    if (known === undefined) {
      this.#onEdges.set(key, first)
      for (let k = 1; k < segments; k++) {
        const at = k / segments
        const [p, q] = uvs.map(([u0, v0, u1, v1]) => [u0 + at * (u1 - u0), v0 + at * (v1 - v0)])
        this.vertices.add([from, to, from], [1 - at, at, 0], [p[0], p[1], q[0], q[1]])
      }
    }
    return first + t * segments - 1
  }
}

/** Squared length, times the square of `WHOLE`, of a step within a triangle, given by how much its first two barycentrics change. */
function squaredLengths(
  positions: ArrayLike<number>,
  [a, b, c]: readonly [number, number, number],
): (dx: number, dy: number) => number {
  let [xx, xy, yy] = [0, 0, 0]
  for (let axis = 0; axis < 3; axis++) {
    const x = positions[3 * a + axis] - positions[3 * c + axis]
    const y = positions[3 * b + axis] - positions[3 * c + axis]
    xx += x * x
    xy += x * y
    yy += y * y
  }
  return (dx, dy) => dx * dx * xx + 2 * dx * dy * xy + dy * dy * yy
}

/** Of each first vertex two of the texture coordinates at its position, the same for all vertices there. */
function uvsOfPoints({ uvs }: CoarseMesh, firstOf: Uint32Array): [number, number, number, number][] {
  const found: [number, number, number, number][] = []
  for (const [vertex, first] of firstOf.entries()) {
    const [u, v] = [uvs[2 * vertex], uvs[2 * vertex + 1]]
    const known = found[first]
    if (!known) found[first] = [u, v, u, v]
    else if (u < known[0] || (u === known[0] && v < known[1])) [known[0], known[1]] = [u, v]
    else if (u > known[2] || (u === known[2] && v > known[3])) [known[2], known[3]] = [u, v]
  }
  return found
}
