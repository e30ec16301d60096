import { uvToTexels } from '../math/triangle.ts'
import type { CoarseMesh } from './coarse-mesh.ts'
import { coverage } from './covered-triangles.ts'
import { PHONG } from './displaced.ts'
import { type HeightField, raisedTexels } from './height-fields.ts'
import { MAX_LEVEL, nextCorner } from './welded-edges.ts'

/**
 * Maximum error of the surface in metres, for each version of the dense mesh: less than half a pixel at 10, 5 and 2.5 pixels per millimetre.
 * At 10 pixels per millimetre, a head is 2,000 pixels high.
 */
export const TOLERANCES = [0.00004, 0.00008, 0.00016] as const

/**
 * Fraction of the maximum error that is allowed on edges, because the error is larger inside a triangle. For an equilateral triangle on a
 * sphere, it is 4/3 of the error on the edges.
 */
const ON_EDGES = 3 / 4

/** Maximum number of halvings of a triangle's edges when heights are sampled, about one sample per texel. */
const MAX_GRID_HALVINGS = 5

/**
 * Computes how often to halve each edge of each triangle, so that the mesh follows the heights and the curvature of the surface. The error of
 * an edge is the maximum over all lines in the triangle that are parallel to the edge. Triangles are therefore split across folds, not along
 * them. Triangles with linear heights are not split.
 *
 * @param normals unit normals at rest.
 * @param levels mipmap level of the heights at each vertex, see `heightLevels`.
 * @returns for each tolerance, the halvings of the edge from each corner to the next. Values are fractional: an edge with 1.5 is halved twice,
 *   but inner lines that are slightly longer than half of the edge are halved only once.
 */
export function* neededHalvings(
  mesh: CoarseMesh,
  normals: ArrayLike<number>,
  fields: readonly HeightField[],
  levels: ArrayLike<number>,
): Generator<void, Float32Array[]> {
  const { uvs, triangles } = mesh
  // Heights below half the tolerance need no vertices: the error is below the tolerance.
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
      // Starts with the coarsest version, because finer versions contain its vertices.
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
 * Returns a function from a number of halvings to the error in metres along lines parallel to an edge. The error of a curved edge is divided by
 * four with each halving.
 */
function missesOf(grids: readonly Grid[], edge: number, bulge: number): (halvings: number) => number {
  const known: number[] = []
  return (halvings) => {
    known[halvings] ??= grids.reduce((sum, grid) => sum + grid.error(edge, halvings), bulge / 4 ** halvings)
    return known[halvings]
  }
}

/** Minimum number of halvings. The value -3 means that the edge could be eight times as long. */
const FEWEST = -3

/** Returns the number of halvings, usually fractional, after which the error is within the tolerance. */
function halvingsFor(misses: (halvings: number) => number, tolerance: number): number {
  let enough = 0
  while (enough < MAX_LEVEL && misses(enough) > tolerance) enough++
  const before = Math.max(enough - 1, 0)
  return Math.min(before + Math.log2(misses(before) / tolerance) / 2, enough)
}

/**
 * Increases halvings until the numbers of parts of a triangle's edges meet the triangle inequality. `splitPatch` treats them as edge lengths.
 *
 * @param first index of the first of the triangle's three values.
 */
function balance(halvings: Float32Array, first: number): void {
  const [a, b, c] = [first, first + 1, first + 2].sort((i, k) => halvings[i] - halvings[k])
  const rest = 2 ** halvings[c] - 2 ** halvings[a]
  if (rest > 2 ** halvings[b]) halvings[b] = Math.log2(rest)
}

/** Computes the maximum distance between a straight edge and the edge curved by Phong tessellation (see `displace`), metres. */
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

/** Displacements sampled on a triangle, on a regular grid of barycentric coordinates. */
class Grid {
  readonly #field: HeightField
  #steps = 1
  readonly #values = new Float64Array((2 ** MAX_GRID_HALVINGS + 1) ** 2)
  /** Array offsets by edge: index of the edge's first value, step to the next value along the edge, and step to the next row. */
  readonly #from = new Int32Array(3)
  readonly #along = new Int32Array(3)
  readonly #across = new Int32Array(3)

  constructor(field: HeightField) {
    this.#field = field
  }

  /**
   * Samples another triangle.
   *
   * @param corners x and y of the triangle's corners, texels.
   * @param steps number of steps along each edge.
   * @returns false if all displacements are 0.
   */
  read([ax, ay, bx, by, cx, cy]: Float64Array, steps: number, mipmap: number): boolean {
    this.#steps = steps
    const column = steps + 1
    // The value at i steps towards the first corner and j steps towards the second has the index i * column + j.
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

  /** Computes the maximum error if every row parallel to an edge is halved some times and its parts are straight. */
  error(edge: number, halvings: number): number {
    const stride = this.#steps / 2 ** halvings
    if (stride <= 1) return 0
    const step = this.#along[edge]
    let worst = 0
    // The first row is the edge itself. Each further row is one step shorter.
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
