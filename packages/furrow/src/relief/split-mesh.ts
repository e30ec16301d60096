import type { CoarseMesh } from './coarse-mesh.ts'
import { DenseBuilder, type DenseMesh } from './dense-mesh.ts'
import { MAX_TRIANGLES } from './max-triangles.ts'
import { PairNumbers } from './pair-numbers.ts'
import { COORDINATE_SUM, splitPatch } from './patch.ts'
import { WeldedEdges } from './welded-edges.ts'

export interface SplitOptions {
  /** Target edge length in metres. */
  edge?: number
  /** Maximum number of triangles. If the mesh would have more, the target edge length is increased. */
  budget?: number
  /**
   * Halvings for each coarser version of the mesh, in the format of the argument `halvings`. Finer versions come first. No edge may have more
   * halvings than in a finer version.
   */
  coarser?: readonly Float32Array[]
}

export const SPLIT_DEFAULTS: Required<SplitOptions> = { edge: 0.0012, budget: MAX_TRIANGLES, coarser: [] }

/** Edges longer than this multiple of the target length are halved. The resulting edges have 0.7 to 1.4 times the target length. */
const MAX_EDGE_FACTOR = Math.SQRT2

/** Number of coarse triangles between two yields. */
const SLICE = 256

/**
 * Subdivides the triangles of a mesh without T-junctions.
 *
 * @param halvings maximum number of halvings for the three edges of each triangle; see `neededHalvings`. The numbers may be fractional. An
 *   edge is not halved further once its parts have about the target length.
 * @returns generator that yields between parts of the work, and returns the dense mesh.
 */
export function* splitMesh(
  mesh: CoarseMesh,
  halvings: Float32Array,
  options: SplitOptions = {},
): Generator<void, DenseMesh> {
  const { edge: wanted, budget, coarser } = { ...SPLIT_DEFAULTS, ...options }
  const edges = new WeldedEdges(mesh)
  yield
  const edge = fitBudget(halvings, edges, wanted, budget)
  yield
  const versions = [halvings, ...coarser]
  const levels = versions.map((version) => edges.levelsFor(version, MAX_EDGE_FACTOR * edge))
  yield
  const splitter = new Splitter(mesh, edges, levels, MAX_EDGE_FACTOR * edge)
  for (let t = 0; 3 * t < halvings.length; t++) {
    splitter.split(t, versions)
    if (t % SLICE === SLICE - 1) yield
  }
  return splitter.dense.finish(edge)
}

/** Returns a target edge length of at least `wanted` metres for which the number of triangles is at most `budget`. */
function fitBudget(halvings: Float32Array, edges: WeldedEdges, wanted: number, budget: number): number {
  for (let edge = wanted; ; ) {
    const levels = edges.levelsFor(halvings, MAX_EDGE_FACTOR * edge)
    const count = countTriangles(edges.edgeOf, levels)
    if (count <= budget || levels.every((level) => level === 0)) return edge
    edge *= Math.max(1.05, Math.sqrt(count / budget))
  }
}

/** Estimates the number of triangles after subdivision. Halving all three edges of a triangle results in four triangles. */
function countTriangles(edgeOf: Uint32Array, levels: Uint8Array): number {
  let sum = 0
  for (let k = 0; k < edgeOf.length; k += 3) {
    sum += 2 ** ((2 * (levels[edgeOf[k]] + levels[edgeOf[k + 1]] + levels[edgeOf[k + 2]])) / 3)
  }
  return sum
}

/** Subdivides triangles one by one, for all versions of the mesh. Triangles with a common edge share the vertices on this edge. */
class Splitter {
  readonly dense: DenseBuilder
  readonly #mesh: CoarseMesh
  readonly #edges: WeldedEdges
  readonly #levels: readonly Uint8Array[]
  readonly #longest: number
  /**
   * Assigns a number to each split edge. An edge is a pair of coarse vertices, so the two triangles at a texture seam have different edges.
   */
  readonly #cut: PairNumbers
  /** For each split edge, the index of the first dense vertex on it. */
  readonly #onEdges: Uint32Array

  /** @param levels number of halvings of each edge, for each version; the finest version is first. */
  constructor(mesh: CoarseMesh, edges: WeldedEdges, levels: readonly Uint8Array[], longest: number) {
    this.#mesh = mesh
    this.#edges = edges
    this.#levels = levels
    this.#longest = longest
    this.#cut = new PairNumbers(edges.edgeOf.length)
    this.#onEdges = new Uint32Array(edges.edgeOf.length)
    this.dense = new DenseBuilder(edges.firstOf, levels.length)
    const uvs = uvsOfPoints(mesh, edges.firstOf)
    for (let i = 0; i < edges.firstOf.length; i++) {
      const k = 4 * edges.firstOf[i]
      this.dense.addVertex([i, i, i], [1, 0, 0], [uvs[k], uvs[k + 1], uvs[k + 2], uvs[k + 3]])
    }
  }

  /**
   * Subdivides triangle `t`.
   *
   * @param versions halvings of all edges, one array per version; see `neededHalvings`.
   */
  split(t: number, versions: readonly Float32Array[]): void {
    const { triangles, positions } = this.#mesh
    const { edgeOf } = this.#edges
    const corners = [triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]] as const
    const limit = (this.#longest * COORDINATE_SUM) ** 2
    let squared: ((dx: number, dy: number) => number) | null = null
    const known = new Map<number, number>()
    for (let version = 0; version < versions.length; version++) {
      const all = this.#levels[version]
      const levels = [all[edgeOf[3 * t]], all[edgeOf[3 * t + 1]], all[edgeOf[3 * t + 2]]] as const
      if (levels[0] + levels[1] + levels[2] === 0) {
        this.dense.addTriangle(version, corners[0], corners[1], corners[2])
        continue
      }
      squared ??= squaredLengths(positions, corners)
      const length = squared
      const parts = partsOf(versions[version], 3 * t)
      splitPatch(
        {
          corners,
          levels,
          isLong: (dx, dy) => parts(dx, dy) > COORDINATE_SUM ** 2 && length(dx, dy) > limit,
          onEdge: (edge, part) => this.#onEdge(3 * t + edge, corners[edge], corners[(edge + 1) % 3], part),
          inside: (x, y) => this.#inside(corners, x, y, known),
        },
        (p, q, r) => this.dense.addTriangle(version, p, q, r),
      )
    }
  }

  /**
   * Returns the vertex inside a triangle at integer barycentric coordinates. Creates the vertex if it does not exist.
   *
   * @param known existing vertices inside this triangle.
   */
  #inside(
    corners: readonly [number, number, number],
    x: number,
    y: number,
    known: Map<number, number>,
  ): number {
    const key = x * (COORDINATE_SUM + 1) + y
    const found = known.get(key)
    if (found !== undefined) return found
    const { uvs } = this.#mesh
    const [a, b, c] = corners
    const [wa, wb, wc] = [x / COORDINATE_SUM, y / COORDINATE_SUM, (COORDINATE_SUM - x - y) / COORDINATE_SUM]
    const u = wa * uvs[2 * a] + wb * uvs[2 * b] + wc * uvs[2 * c]
    const v = wa * uvs[2 * a + 1] + wb * uvs[2 * b + 1] + wc * uvs[2 * c + 1]
    const vertex = this.dense.addVertex(corners, [wa, wb, wc], [u, v, u, v])
    known.set(key, vertex)
    return vertex
  }

  /** Returns the vertex on the edge from `a` to `b`, at position `part` along the edge, 0..1. */
  #onEdge(corner: number, a: number, b: number, part: number): number {
    const isForward = this.#edges.startsAt(a, b)
    const from = isForward ? a : b
    const to = isForward ? b : a
    const edge = this.#edges.edgeOf[corner]
    // Creates all vertices that the finest version has on this edge. Coarser versions use some of them.
    const segments = 2 ** this.#levels[0][edge]
    const { count } = this.#cut
    const cut = this.#cut.numberOf(from, to)
    if (cut === count) {
      this.#onEdges[cut] = this.dense.count
      for (let k = 1; k < segments; k++) this.#addOnEdge(edge, from, to, k / segments)
    }
    return this.#onEdges[cut] + (isForward ? part : 1 - part) * segments - 1
  }

  #addOnEdge(edge: number, from: number, to: number, at: number): void {
    const edges = this.#edges
    this.dense.addVertex(
      [from, to, from],
      [1 - at, at, 0],
      [edges.uvAt(edge, at, 0), edges.uvAt(edge, at, 1), edges.uvAt(edge, at, 2), edges.uvAt(edge, at, 3)],
    )
  }
}

/**
 * Returns a function that measures lines inside a triangle in an anisotropic metric (see P.-L. George, H. Borouchaki, "Delaunay
 * Triangulation and Meshing", 1998). The length of an edge of the triangle in this metric is the number of parts into which the edge is
 * split. A line with a length over 1 must therefore be halved.
 *
 * The arguments of the function are the differences of the first two integer barycentric coordinates between the ends of the line. It
 * returns the squared length times `COORDINATE_SUM ** 2`.
 *
 * @param first index of the triangle's first number in `halvings`.
 */
function partsOf(halvings: Float32Array, first: number): (dx: number, dy: number) => number {
  const [ab, bc, ca] = [4 ** halvings[first], 4 ** halvings[first + 1], 4 ** halvings[first + 2]]
  return (dx, dy) => dx * dx * ca + dx * dy * (ca + bc - ab) + dy * dy * bc
}

/**
 * Returns a function that measures lines inside a triangle in metres. The arguments of the function are the differences of the first two
 * integer barycentric coordinates between the ends of the line. It returns the squared length times `COORDINATE_SUM ** 2`.
 */
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

/**
 * Returns two pairs of texture coordinates for each position: the lexicographically smallest and largest pairs of the vertices there.
 * The four numbers of a position start at 4 times the index of its first vertex.
 */
function uvsOfPoints({ uvs }: CoarseMesh, firstOf: Uint32Array): Float64Array {
  const found = new Float64Array(4 * firstOf.length)
  for (let vertex = 0; vertex < firstOf.length; vertex++) {
    const first = 4 * firstOf[vertex]
    const last = first + 2
    const u = uvs[2 * vertex]
    const v = uvs[2 * vertex + 1]
    // The loop visits the first vertex at a position before the other vertices at this position.
    const isNew = first === 4 * vertex
    if (isNew || u < found[first] || (u === found[first] && v < found[first + 1])) {
      found[first] = u
      found[first + 1] = v
    }
    if (isNew || u > found[last] || (u === found[last] && v > found[last + 1])) {
      found[last] = u
      found[last + 1] = v
    }
  }
  return found
}
