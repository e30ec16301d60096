import type { Uv } from '../../core/json.ts'
import { barycentrics2 } from '../../math/barycentrics.ts'
import { type Skin, type SkinSurface, skinVertices } from './surface.ts'

/** Maximum number of cells along each side of the grid. */
const MAX_CELLS = 512
/** Desired average number of cells that list a triangle. */
const ENTRIES = 4
/** Minimum barycentric coordinate of a point inside a triangle. It is below 0, because points on an edge are rounded. */
const INSIDE = -1e-9
/** Files store rounded coordinates, so `find` also accepts points near an island. It tries the first of these UV distances, then the second. */
const MARGINS = [2 ** -12, 2 ** -10]
const DIRECTIONS = [-1, 0, 1].flatMap((x) => [-1, 0, 1].flatMap((y) => (x || y ? [[x, y] as const] : [])))

/** Grid over UV space that lists the triangles in each cell, as arrays that can be transferred between workers. */
export interface UvGrid {
  /** Number of cells along each side. */
  side: number
  /** Start of each cell's list in `triangles`, by row-major cell index. The list of cell i ends before index `starts[i + 1]`. */
  starts: Uint32Array
  /** Lists of the triangles whose bounding boxes overlap a cell, one list per cell. */
  triangles: Uint32Array
}

/** Finds the triangle of a skin at a UV point, with a grid over the texture. */
export class UvLocator {
  readonly #skin: Pick<Skin, 'uvs' | 'indices'>
  readonly #surface: SkinSurface
  readonly grid: UvGrid
  readonly #corners = new Float64Array(6)
  readonly #candidate = new Float64Array(3)

  /**
   * @param skin UVs outside 0..1 are ignored.
   * @param grid lists the triangles to search. Where triangles overlap, the locator finds the first one in the list.
   */
  constructor(
    skin: Pick<Skin, 'uvs' | 'indices'>,
    surface: SkinSurface,
    grid: UvGrid = uvGridOf(skin, surface),
  ) {
    this.#skin = skin
    this.#surface = surface
    this.grid = grid
  }

  /**
   * Finds the triangle at a UV point.
   *
   * @param weights receives the barycentric coordinates; some are slightly negative if the point is just outside an island.
   * @returns the triangle; -1 if there is no skin at the point.
   */
  find(u: number, v: number, weights: Float64Array): number {
    const triangle = this.#triangleAt(u, v)
    if (triangle >= 0) return this.#locate(triangle, u, v, weights)
    for (const distance of MARGINS) {
      for (const [x, y] of DIRECTIONS) {
        const beside = this.#triangleAt(u + distance * x, v + distance * y)
        if (beside >= 0) return this.#locate(beside, u, v, weights)
      }
    }
    return -1
  }

  /** Returns u and v at barycentric coordinates of a triangle. */
  uvAt(triangle: number, weights: Float64Array): Uv {
    this.#readCorners(triangle)
    const c = this.#corners
    return [
      weights[0] * c[0] + weights[1] * c[2] + weights[2] * c[4],
      weights[0] * c[1] + weights[1] * c[3] + weights[2] * c[5],
    ]
  }

  #locate(triangle: number, u: number, v: number, weights: Float64Array): number {
    this.#readCorners(triangle)
    barycentrics2(weights, this.#corners, u, v)
    return triangle
  }

  #triangleAt(u: number, v: number): number {
    if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1)) return -1
    const { side, starts, triangles } = this.grid
    const cell = cellOf(v, side) * side + cellOf(u, side)
    const weights = this.#candidate
    for (let i = starts[cell]; i < starts[cell + 1]; i++) {
      this.#locate(triangles[i], u, v, weights)
      if (weights[0] >= INSIDE && weights[1] >= INSIDE && weights[2] >= INSIDE) return triangles[i]
    }
    return -1
  }

  #readCorners(triangle: number): void {
    readCorners(this.#corners, this.#skin, this.#surface, triangle)
  }
}

/** Builds a grid that lists the triangles selected by `isUsed`. */
export function uvGridOf(
  skin: Pick<Skin, 'uvs' | 'indices'>,
  surface: SkinSurface,
  isUsed: (triangle: number) => boolean = () => true,
): UvGrid {
  const used = [...surface.skinTriangles.keys()].filter(isUsed)
  const corners = new Float64Array(6)
  const boxOf = (triangle: number): UvBox => {
    readCorners(corners, skin, surface, triangle)
    const c = corners
    return [
      Math.min(c[0], c[2], c[4]),
      Math.min(c[1], c[3], c[5]),
      Math.max(c[0], c[2], c[4]),
      Math.max(c[1], c[3], c[5]),
    ]
  }
  const side = chooseSide(used, boxOf)
  const visitCells = (triangle: number, visit: (cell: number) => void) => {
    const [left, top, right, bottom] = boxOf(triangle)
    if (!(right >= 0 && left <= 1 && bottom >= 0 && top <= 1)) return
    for (let row = cellOf(top, side); row <= cellOf(bottom, side); row++) {
      for (let column = cellOf(left, side); column <= cellOf(right, side); column++)
        visit(row * side + column)
    }
  }
  const starts = new Uint32Array(side ** 2 + 1)
  for (const triangle of used) visitCells(triangle, (cell) => starts[cell + 1]++)
  for (let i = 1; i < starts.length; i++) starts[i] += starts[i - 1]
  const triangles = new Uint32Array(starts[starts.length - 1])
  const next = starts.slice()
  for (const triangle of used) {
    visitCells(triangle, (cell) => {
      triangles[next[cell]++] = triangle
    })
  }
  return { side, starts, triangles }
}

type UvBox = readonly [left: number, top: number, right: number, bottom: number]

/** Chooses the number of cells along each side so that a triangle is listed in about `ENTRIES` cells on average. */
function chooseSide(triangles: readonly number[], boxOf: (triangle: number) => UvBox): number {
  let [area, extent] = [0, 0]
  for (const triangle of triangles) {
    const [left, top, right, bottom] = boxOf(triangle)
    area += (right - left) * (bottom - top)
    extent += right - left + bottom - top
  }
  const entries = ENTRIES * triangles.length
  const side = Math.min(Math.sqrt(entries / (area || 1)), entries / (extent || 1))
  return Math.max(1, Math.min(MAX_CELLS, Math.floor(side)))
}

function cellOf(coordinate: number, side: number): number {
  return Math.max(0, Math.min(side - 1, Math.floor(coordinate * side)))
}

function readCorners(
  out: Float64Array,
  skin: Pick<Skin, 'uvs' | 'indices'>,
  surface: SkinSurface,
  triangle: number,
): void {
  const vertices = skinVertices(skin, surface, triangle)
  for (let k = 0; k < 3; k++) {
    out[2 * k] = skin.uvs[2 * vertices[k]]
    out[2 * k + 1] = skin.uvs[2 * vertices[k] + 1]
  }
}
