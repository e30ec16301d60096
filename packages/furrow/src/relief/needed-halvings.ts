import { uvToTexels } from '../math/triangle.ts'
import type { CoarseMesh } from './coarse-mesh.ts'
import { coveredTriangles } from './covered-triangles.ts'
import { PHONG } from './displaced.ts'
import { type HeightField, raisedTexels } from './height-fields.ts'
import { MAX_LEVEL } from './welded-edges.ts'

/**
 * Metres by which a surface may miss its heights, in each version of it: less than half a pixel where a millimetre is 10 pixels, and a
 * head 2,000; where it is 5; and where it is 2.5. Most of a face with automatic wrinkles is flat enough as it is.
 */
export const TOLERANCES = [0.00004, 0.00008, 0.00016] as const

/** Halvings of heights at most that are tried, in as many steps as there are texels. */
const MOST = 5

/**
 * Finds how often the edges of each triangle are to be halved, so that planes between its points follow the surface: the heights, and how it
 * is curved where it moves. A flat triangle between whose corners heights rise evenly is not split at all.
 *
 * @param normals unit normals at rest.
 * @param levels of the heights' mipmaps, at each vertex, see `heightLevels`.
 * @returns halvings of each triangle, for each of the tolerances.
 */
export function neededHalvings(
  mesh: CoarseMesh,
  normals: ArrayLike<number>,
  fields: readonly HeightField[],
  levels: ArrayLike<number>,
): Uint8Array[] {
  const { uvs, triangles } = mesh
  // A surface misses heights that are half as large by no more than the tolerance.
  const covered = coveredTriangles(mesh, raisedTexels(fields, TOLERANCES[0] / 2))
  const needed = TOLERANCES.map(() => new Uint8Array(covered.length))
  const corners = new Float64Array(6)
  const [{ width, height }] = fields
  for (const [t, isCovered] of covered.entries()) {
    if (!isCovered) continue
    errors.fill(0)
    const [a, b, c] = [triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]]
    uvToTexels(corners, uvs, a, b, c, width, height)
    for (const field of fields) addMisses(corners, field, (levels[a] + levels[b] + levels[c]) / 3)
    const bulge = bulgeOf(mesh, normals, t)
    for (const [i, tolerance] of TOLERANCES.entries()) {
      // Half of an edge is a quarter as far from a curve.
      const enough = errors.findIndex((error, halvings) => !(error + bulge / 4 ** halvings > tolerance))
      needed[i][t] = enough < 0 ? MAX_LEVEL : enough
    }
  }
  return needed
}

/** Metres by which heights are missed after each number of halvings. */
const errors = new Float64Array(MAX_LEVEL + 1)

/** How far the edges of a triangle are from the surface that is curved through their ends, see `displace`, in metres. */
function bulgeOf({ positions, triangles }: CoarseMesh, normals: ArrayLike<number>, t: number): number {
  let bulge = 0
  for (let k = 0; k < 3; k++) {
    const [from, to] = [3 * triangles[3 * t + k], 3 * triangles[3 * t + ((k + 1) % 3)]]
    let [start, end] = [0, 0]
    for (let axis = 0; axis < 3; axis++) {
      const step = positions[to + axis] - positions[from + axis]
      start += step * normals[from + axis]
      end += step * normals[to + axis]
    }
    bulge = Math.max(bulge, (PHONG / 4) * (Math.abs(start) + Math.abs(end)))
  }
  return bulge
}

/** @param corners of a triangle, in texels. */
function addMisses(corners: Float64Array, field: HeightField, mipmap: number): void {
  const most = Math.min(Math.max(Math.ceil(Math.log2(longestSide(corners))), 0), MOST)
  const grid = new Grid(corners, field, mipmap, 2 ** most)
  if (grid.isFlat) return
  for (let level = 0; level < most; level++) errors[level] += grid.error(2 ** (most - level))
}

function longestSide([ax, ay, bx, by, cx, cy]: Float64Array): number {
  return Math.max(Math.hypot(bx - ax, by - ay), Math.hypot(cx - bx, cy - by), Math.hypot(ax - cx, ay - cy))
}

/** Heights on a triangle, in equal steps along its sides. */
class Grid {
  readonly #steps: number
  readonly #values: Float64Array
  /** Whether no height differs from the surface: the layer is none of this skin. */
  readonly isFlat: boolean

  constructor([ax, ay, bx, by, cx, cy]: Float64Array, field: HeightField, mipmap: number, steps: number) {
    this.#steps = steps
    this.#values = new Float64Array((steps + 1) ** 2)
    for (let i = 0; i <= steps; i++) {
      for (let j = 0; i + j <= steps; j++) {
        const [a, b] = [i / steps, j / steps]
        const c = 1 - a - b
        const [x, y] = [ax * a + bx * b + cx * c, ay * a + by * b + cy * c]
        this.#values[i * (steps + 1) + j] = field.between(x, y, mipmap)
      }
    }
    this.isFlat = this.#values.every((value) => value === 0)
  }

  /** The farthest that heights are from planes between every so manieth of them. */
  error(stride: number): number {
    let worst = 0
    for (let i = 0; i <= this.#steps; i++) {
      for (let j = 0; i + j <= this.#steps; j++) {
        worst = Math.max(worst, Math.abs(this.#at(i, j) - this.#plane(i, j, stride)))
      }
    }
    return worst
  }

  #plane(i: number, j: number, stride: number): number {
    const i0 = i - (i % stride)
    const j0 = j - (j % stride)
    const a = (i - i0) / stride
    const b = (j - j0) / stride
    if (a + b === 0) return this.#at(i, j)
    const ahead = this.#at(i0 + stride, j0)
    const beside = this.#at(i0, j0 + stride)
    if (a + b <= 1) return this.#at(i0, j0) * (1 - a - b) + ahead * a + beside * b
    return this.#at(i0 + stride, j0 + stride) * (a + b - 1) + ahead * (1 - b) + beside * (1 - a)
  }

  #at(i: number, j: number): number {
    return this.#values[i * (this.#steps + 1) + j]
  }
}
