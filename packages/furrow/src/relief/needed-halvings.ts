import { uvToTexels } from '../math/triangle.ts'
import type { CoarseMesh } from './coarse-mesh.ts'
import { coverage } from './covered-triangles.ts'
import { PHONG } from './displaced.ts'
import { type HeightField, raisedTexels } from './height-fields.ts'
import { MAX_LEVEL, nextCorner } from './welded-edges.ts'

/**
 * Maximum distance, in metres, between the dense mesh and the exact displaced surface, for each version of the dense mesh; finest first. The
 * distances are less than half a pixel at 10, 5 and 2.5 pixels per millimetre. At 10 pixels per millimetre, a head is 2,000 pixels high.
 */
export const TOLERANCES = [0.00004, 0.00008, 0.00016] as const

/**
 * Error allowed on the edges of triangles, as a fraction of the maximum error. The error inside a triangle is larger: for an equilateral
 * triangle on a sphere, it is 4/3 of the error on the edges.
 */
const ON_EDGES = 3 / 4

/** Maximum number of times that an edge is halved to sample heights. Edges of up to 32 texels are sampled at least once per texel. */
const MAX_GRID_HALVINGS = 5

/**
 * Computes how often each edge of a triangle must be halved, so that the mesh follows the heights and the curvature of the surface. For each
 * edge, the error is measured along the edge and along all lines in the triangle that are parallel to it. An edge that runs across a fold is
 * therefore halved more often than an edge that runs along the fold. Edges are not halved where heights are linear.
 *
 * @param normals unit normals at rest.
 * @param levels mipmap level of the heights at each vertex; see `heightLevels`.
 * @returns generator that yields between parts of the work. It returns an array for each of `TOLERANCES`. The array contains three numbers of
 *   halvings per triangle, for the edge from each corner to the next. An edge with a fractional number such as 1.5 is halved twice, but
 *   shorter parallel lines in the triangle may be halved only once.
 */
export function* neededHalvings(
  mesh: CoarseMesh,
  normals: ArrayLike<number>,
  fields: readonly HeightField[],
  levels: ArrayLike<number>,
): Generator<void, Float32Array[]> {
  const { uvs, triangles } = mesh
  // Triangles with displacements of at most half the finest tolerance are not halved, not even for their curvature. Interpolated between their
  // corners, such displacements are wrong by at most the tolerance.
  const isCovered = coverage(mesh, yield* raisedTexels(fields, TOLERANCES[0] / 2))
  const count = Math.floor(triangles.length / 3)
  const needed = TOLERANCES.map(() => new Float32Array(3 * count))
  const corners = new Float64Array(6)
  const [{ width, height }] = fields
  const all = fields.map((field) => new Grid(field))
  for (let t = 0; t < count; t++) {
    if (t % SLICE === 0) yield
    if (!isCovered(t)) continue
    const a = triangles[3 * t]
    const b = triangles[3 * t + 1]
    const c = triangles[3 * t + 2]
    uvToTexels(corners, uvs, a, b, c, width, height)
    const mipmap = (levels[a] + levels[b] + levels[c]) / 3
    const steps = 2 ** Math.min(Math.max(Math.ceil(Math.log2(longestSide(corners))), 0), MAX_GRID_HALVINGS)
    const grids = all.filter((grid) => grid.read(corners, steps, mipmap))
    for (let k = 0; k < 3; k++) {
      const edge = 3 * t + k
      const bulge = bulgeOf(mesh, normals, edge)
      const misses = missesOf(grids, k, bulge)
      // The loop starts with the coarsest version. A version contains all vertices of the coarser versions, so an edge is halved at least as
      // often as in the coarser versions.
      let halvings = FEWEST
      for (let i = TOLERANCES.length - 1; i >= 0; i--) {
        halvings = Math.max(halvings, halvingsFor(misses, ON_EDGES * TOLERANCES[i]))
        needed[i][edge] = halvings
      }
    }
    for (const own of needed) balance(own, 3 * t)
  }
  return needed
}

/** Number of triangles between two yields. */
const SLICE = 256

/**
 * Returns a function that computes the error, in metres, for a number of halvings of an edge. The function caches its results.
 *
 * @param bulge error in metres that the curvature of the surface causes along the undivided edge. Each halving divides this error by four.
 */
function missesOf(grids: readonly Grid[], edge: number, bulge: number): (halvings: number) => number {
  const known: number[] = []
  return (halvings) => {
    known[halvings] ??= grids.reduce((sum, grid) => sum + grid.error(edge, halvings), bulge / 4 ** halvings)
    return known[halvings]
  }
}

/** Minimum number of halvings. A number of -3 means that the edge could be eight times as long as it is. */
const FEWEST = -3

/** Estimates the fractional number of halvings at which the error equals the tolerance. */
function halvingsFor(misses: (halvings: number) => number, tolerance: number): number {
  let enough = 0
  while (enough < MAX_LEVEL && misses(enough) > tolerance) enough++
  const before = Math.max(enough - 1, 0)
  return Math.min(before + Math.log2(misses(before) / tolerance) / 2, enough)
}

/**
 * Increases the halvings of a triangle's edges so that the values of `2 ** halvings` meet the triangle inequality. `splitMesh` uses these
 * values, the numbers of parts of the edges, as edge lengths.
 *
 * @param first index of the triangle's first number in `halvings`.
 */
function balance(halvings: Float32Array, first: number): void {
  const [a, b, c] = [first, first + 1, first + 2].sort((i, k) => halvings[i] - halvings[k])
  const rest = 2 ** halvings[c] - 2 ** halvings[a]
  if (rest > 2 ** halvings[b]) halvings[b] = Math.log2(rest)
}

/** Computes the maximum distance, in metres, between a straight edge and the same edge after Phong tessellation. */
function bulgeOf({ positions, triangles }: CoarseMesh, normals: ArrayLike<number>, corner: number): number {
  const [from, to] = [3 * triangles[corner], 3 * triangles[nextCorner(corner)]]
  let [start, end] = [0, 0]
  for (let axis = 0; axis < 3; axis++) {
    const step = positions[to + axis] - positions[from + axis]
    start += step * normals[from + axis]
    end += step * normals[to + axis]
  }
  return (PHONG / 4) * (Math.abs(start) + Math.abs(end))
}

function longestSide([ax, ay, bx, by, cx, cy]: Float64Array): number {
  return Math.max(Math.hypot(bx - ax, by - ay), Math.hypot(cx - bx, cy - by), Math.hypot(ax - cx, ay - cy))
}

/** Displacements of one triangle, sampled on a regular grid of barycentric coordinates. */
class Grid {
  readonly #field: HeightField
  #steps = 1
  readonly #values = new Float64Array((2 ** MAX_GRID_HALVINGS + 1) ** 2)
  /** For each edge, the index of its first value in `#values`. */
  readonly #from = new Int32Array(3)
  /** For each edge, the step in `#values` to the next value along the edge. */
  readonly #along = new Int32Array(3)
  /** For each edge, the step in `#values` to the next line that is parallel to the edge. */
  readonly #across = new Int32Array(3)

  constructor(field: HeightField) {
    this.#field = field
  }

  /**
   * Samples the displacements of a triangle. Replaces the samples of the previous triangle.
   *
   * @param corners x and y of the triangle's corners, in texels.
   * @param steps number of steps along each edge.
   * @returns false if all displacements are 0.
   */
  read([ax, ay, bx, by, cx, cy]: Float64Array, steps: number, mipmap: number): boolean {
    this.#steps = steps
    const column = steps + 1
    // The value at barycentric coordinates (i / steps, j / steps) has the index i * column + j.
    this.#from.set([steps * column, steps, 0])
    this.#along.set([1 - column, -1, column])
    this.#across.set([-column, column - 1, 1])
    let isRaised = false
    for (let i = 0; i <= steps; i++) {
      for (let j = 0; i + j <= steps; j++) {
        const a = i / steps
        const b = j / steps
        const c = 1 - a - b
        const metres = this.#field.between(ax * a + bx * b + cx * c, ay * a + by * b + cy * c, mipmap)
        this.#values[i * column + j] = metres
        if (metres !== 0) isRaised = true
      }
    }
    return isRaised
  }

  /**
   * Computes the maximum error, in metres, if an edge and all lines parallel to it are halved `halvings` times and each part becomes
   * straight.
   */
  error(edge: number, halvings: number): number {
    const stride = this.#steps / 2 ** halvings
    if (stride <= 1) return 0
    const step = this.#along[edge]
    let worst = 0
    // Row 0 is the edge. Each following row is a parallel line that is one step shorter.
    for (let row = 0, first = this.#from[edge]; row < this.#steps; row++, first += this.#across[edge]) {
      const length = this.#steps - row
      for (let from = 0; from < length; from += stride) {
        const to = Math.min(from + stride, length)
        const start = this.#values[first + from * step]
        const slope = (this.#values[first + to * step] - start) / (to - from)
        for (let k = from + 1; k < to; k++) {
          worst = Math.max(worst, Math.abs(this.#values[first + k * step] - start - slope * (k - from)))
        }
      }
    }
    return worst
  }
}
