import { barycentrics2, interpolate } from '../../../math/barycentrics.ts'
import { atan2 } from '../../../math/elementary.ts'
import { length2, normalize } from '../../../math/vector.ts'
import { islandsOf } from '../../skin/islands.ts'
import { cornersOf, type SkinSurface, type SurfacePoint } from '../../skin/surface.ts'

/** Distance in millimetres from the eyes to the vertical axis of the head. The axis is behind the eyes. */
const RADIUS = 85

/**
 * Point of the head's chart, which is a cylinder around the vertical axis of the head, unrolled into a plane. `across` is the arc length on
 * the cylinder towards the person's left. `up` is the height above the eyes. Both are in millimetres.
 */
export type ChartPoint = readonly [across: number, up: number]

/** Projects a position in face coordinates (see `DetectedFace`) onto the chart, along the horizontal ray from the head's axis. */
export function unroll(x: number, y: number, z: number): ChartPoint {
  return [RADIUS * atan2(x, z + RADIUS), y]
}

/** Unrolls a point of a packed array of positions, see `unroll`. */
export function unrollPoint(positions: Float64Array, point: number): ChartPoint {
  return unroll(positions[3 * point], positions[3 * point + 1], positions[3 * point + 2])
}

/** Returns the minimum and maximum `across` of a box, given by its lowest and highest x, y and z. */
export function acrossOf(low: ArrayLike<number>, high: ArrayLike<number>): readonly [number, number] {
  if (low[2] <= -RADIUS) return [-Infinity, Infinity]
  const [left] = unroll(low[0], 0, low[0] < 0 ? low[2] : high[2])
  const [right] = unroll(high[0], 0, high[0] < 0 ? high[2] : low[2])
  return [left, right]
}

/**
 * Converts a direction on the chart to a direction in the tangent plane of the skin. This is the inverse of the projection by `unroll`.
 *
 * @param x x of the position on the skin, in face coordinates.
 * @param z z of the position on the skin, in face coordinates.
 * @param normal normal of the skin at the position.
 * @param out receives the direction as a unit vector.
 */
export function rollUp(
  x: number,
  z: number,
  normal: ArrayLike<number>,
  [across, up]: ChartPoint,
  out: Float64Array,
): void {
  const rho = length2(x, z + RADIUS)
  const [sine, cosine] = [x / rho, (z + RADIUS) / rho]
  const [nx, ny, nz] = [normal[0], normal[1], normal[2]]
  const [vx, vy, vz] = [across * cosine, up, -across * sine]
  const facing = nx * sine + nz * cosine
  const rise = nx * vx + ny * vy + nz * vz
  // Project along the ray from the axis, like the chart. If the skin is nearly parallel to the ray, project along the normal.
  const isSteep = facing < 0.2
  const [rx, ry, rz, lift] = isSteep ? [nx, ny, nz, rise] : [sine, 0, cosine, rise / facing]
  out[0] = vx - lift * rx
  out[1] = vy - lift * ry
  out[2] = vz - lift * rz
  normalize(out)
}

/** Barycentric tolerance for points inside a triangle. */
const TOLERANCE = 1e-9
// The chart is divided into square cells. Each cell lists the triangles that touch it.
/** Edge length of a cell in millimetres. */
const CELL = 6
/** Number of cells around the head. */
const COLUMNS = 2 * Math.ceil((Math.PI * RADIUS) / CELL)
/** Number of grid cells in the vertical direction: 50 below and 50 above the eyes. */
const ROWS = 2 * 50
/** Maximum number of triangles per cell. A face of a million triangles has some hundreds; only overlapping skin has more. */
const MAX_TRIANGLES_PER_CELL = 4096
/** Maximum distance, in millimetres, between the skin and a smaller connected component that covers it, such as a beard. */
const COVER = 10

/** Finds the skin at points of the head's chart. In folds, this is the outermost skin. Beards and brows made of separate triangles are ignored. */
export class HeadChart {
  readonly #surface: SkinSurface
  /** Packed chart coordinates per point of the surface. */
  readonly #chartPoints: Float64Array
  /** Start of each cell's list in `#triangles`. The list of cell i ends before index `#starts[i + 1]`. */
  readonly #starts = new Uint32Array(ROWS * COLUMNS + 1)
  /** Lists of the triangles whose bounding boxes touch a cell, one list per cell. */
  readonly #triangles: Uint32Array
  /** For each point of the surface, the area of the point's connected component. */
  readonly #pieces: Float64Array

  constructor(surface: SkinSurface) {
    this.#surface = surface
    const { points } = surface
    this.#chartPoints = new Float64Array((points.length / 3) * 2)
    for (let i = 0; i < points.length / 3; i++) this.#chartPoints.set(unrollPoint(points, i), 2 * i)
    this.#pieces = areasOfPieces(surface)
    const counts = new Uint16Array(ROWS * COLUMNS)
    this.#visitCells((_, cell) => {
      if (counts[cell] < MAX_TRIANGLES_PER_CELL) counts[cell]++
    })
    for (const [cell, count] of counts.entries()) this.#starts[cell + 1] = this.#starts[cell] + count
    this.#triangles = new Uint32Array(this.#starts[counts.length])
    const ends = this.#starts.slice()
    this.#visitCells((triangle, cell) => {
      if (ends[cell] < this.#starts[cell + 1]) this.#triangles[ends[cell]++] = triangle
    })
  }

  /** Returns the outermost skin at a chart point; undefined if there is no skin. */
  find([across, up]: ChartPoint): SurfacePoint | undefined {
    const [row, column] = [rowOf(up), columnOf(across)]
    if (!(row >= 0 && row < ROWS && column >= 0 && column < COLUMNS)) return undefined
    const cell = row * COLUMNS + column
    let found: SurfacePoint | undefined
    let [farthest, piece] = [-Infinity, 0]
    const weights = new Float64Array(3)
    const position = new Float64Array(3)
    const corners = new Float64Array(6)
    for (let i = this.#starts[cell]; i < this.#starts[cell + 1]; i++) {
      const triangle = this.#triangles[i]
      this.#unrolled(triangle, corners)
      barycentrics2(weights, corners, across, up)
      if (!(weights[0] >= -TOLERANCE && weights[1] >= -TOLERANCE && weights[2] >= -TOLERANCE)) continue
      const [a, b, c] = cornersOf(this.#surface, triangle)
      interpolate(position, this.#surface.points, 3, a, b, c, weights[0], weights[1], weights[2])
      const distance = length2(position[0], position[2] + RADIUS)
      const larger = this.#pieces[a] - piece
      // If a smaller connected component covers a larger one at a distance below `COVER`, the smaller one is a beard or a brow.
      if (
        distance <= farthest
          ? !(larger > 0 && farthest - distance < COVER)
          : larger < 0 && distance - farthest < COVER
      )
        continue
      farthest = distance
      piece = this.#pieces[a]
      found = { triangle, position: [position[0], position[1], position[2]] }
    }
    return found
  }

  /** Returns the distance of the outermost skin from the head's axis in millimetres; undefined if there is no skin. */
  radiusAt(point: ChartPoint): number | undefined {
    const found = this.find(point)?.position
    return found && length2(found[0], found[2] + RADIUS)
  }

  /**
   * Measures how exposed a position on the skin is. `facing` is the cosine of the angle between the normal and the outward direction from the
   * head's axis. `depth` is the distance in millimetres below the outermost skin.
   */
  exposure(x: number, y: number, z: number, normal: ArrayLike<number>): { facing: number; depth: number } {
    const rho = length2(x, z + RADIUS)
    const [outerX, , outerZ] = this.find(unroll(x, y, z))?.position ?? [x, y, z]
    return {
      facing: (normal[0] * x + normal[2] * (z + RADIUS)) / rho,
      depth: length2(outerX, outerZ + RADIUS) - rho,
    }
  }

  /** Visits each cell that a triangle's bounding box on the chart touches. */
  #visitCells(visit: (triangle: number, cell: number) => void): void {
    const c = new Float64Array(6)
    for (let triangle = 0; triangle < this.#surface.skinTriangles.length; triangle++) {
      this.#unrolled(triangle, c)
      const [left, right] = [Math.min(c[0], c[2], c[4]), Math.max(c[0], c[2], c[4])]
      // Skip triangles that cross the cut of the chart at the back of the head.
      if (right - left > RADIUS) continue
      const top = Math.min(ROWS - 1, rowOf(Math.max(c[1], c[3], c[5])))
      for (let row = Math.max(0, rowOf(Math.min(c[1], c[3], c[5]))); row <= top; row++) {
        for (let column = columnOf(left); column <= columnOf(right); column++)
          visit(triangle, row * COLUMNS + column)
      }
    }
  }

  #unrolled(triangle: number, out: Float64Array): void {
    const { corners } = this.#surface
    for (let k = 0; k < 3; k++) {
      const point = corners[3 * triangle + k]
      out[2 * k] = this.#chartPoints[2 * point]
      out[2 * k + 1] = this.#chartPoints[2 * point + 1]
    }
  }
}

function areasOfPieces({ corners, areas }: SkinSurface): Float64Array {
  const pieceOf = islandsOf(corners, areas.length)
  const sums = new Float64Array(areas.length)
  for (const [point, piece] of pieceOf.entries()) sums[piece] += areas[point]
  return sums.map((_, point) => sums[pieceOf[point]])
}

function rowOf(up: number): number {
  return Math.floor(up / CELL) + ROWS / 2
}

function columnOf(across: number): number {
  return Math.floor(across / CELL) + COLUMNS / 2
}
