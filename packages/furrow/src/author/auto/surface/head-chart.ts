import { barycentrics2, interpolate } from '../../../math/barycentrics.ts'
import { normalize } from '../../../math/vector.ts'
import { cornersOf, type SkinSurface, type SurfacePoint } from '../../skin/surface.ts'

/** Millimetres from the surface of the face to the axis of the head. */
const RADIUS = 85

/** A point of the head's chart, the face unrolled from a cylinder: millimetres to the person's left around the head, and up. */
export type ChartPoint = readonly [across: number, up: number]

/** Projects a position in the frame of the face onto the chart, along the ray from the axis of the head. */
export function unroll(x: number, y: number, z: number): ChartPoint {
  return [RADIUS * Math.atan2(x, z + RADIUS), y]
}

/**
 * Lifts a direction of the chart onto the skin.
 *
 * @param x, z of the point where the skin is.
 * @param normal of the skin there.
 * @param out takes the direction, of length 1.
 */
export function rollUp(
  x: number,
  z: number,
  normal: ArrayLike<number>,
  [across, up]: ChartPoint,
  out: Float64Array,
): void {
  const rho = Math.hypot(x, z + RADIUS)
  const [sine, cosine] = [x / rho, (z + RADIUS) / rho]
  const [nx, ny, nz] = [normal[0], normal[1], normal[2]]
  const [vx, vy, vz] = [across * cosine, up, -across * sine]
  const facing = nx * sine + nz * cosine
  const rise = nx * vx + ny * vy + nz * vz
  // Along the ray from the axis, as the chart is projected; where the skin is seen edge-on, along its normal.
  const isSteep = facing < 0.2
  const [rx, ry, rz, lift] = isSteep ? [nx, ny, nz, rise] : [sine, 0, cosine, rise / facing]
  out[0] = vx - lift * rx
  out[1] = vy - lift * ry
  out[2] = vz - lift * rz
  normalize(out)
}

/** How far below 0 a barycentric coordinate may be for a point to count as inside. */
const TOLERANCE = 1e-9

/** Finds the skin at points of the chart: the outermost where it lies in folds. */
export class HeadChart {
  readonly #surface: SkinSurface
  /** Two chart coordinates per point of the surface. */
  readonly #chartPoints: Float64Array
  /** Triangles by the cell of the chart that they touch. */
  readonly #cells = new Map<number, number[]>()

  constructor(surface: SkinSurface) {
    this.#surface = surface
    const { points, corners } = surface
    this.#chartPoints = new Float64Array((points.length / 3) * 2)
    for (let i = 0; i < points.length / 3; i++)
      this.#chartPoints.set(unroll(points[3 * i], points[3 * i + 1], points[3 * i + 2]), 2 * i)
    for (let t = 0; t < corners.length / 3; t++) this.#addToCells(t)
  }

  /** @returns undefined where there is no skin. */
  find([across, up]: ChartPoint): SurfacePoint | undefined {
    let found: SurfacePoint | undefined
    let farthest = -Infinity
    const weights = new Float64Array(3)
    const position = new Float64Array(3)
    for (const triangle of this.#cells.get(cellOf(across, up)) ?? []) {
      barycentrics2(weights, this.#chartTriangle(triangle), across, up)
      if (!weights.every((weight) => weight >= -TOLERANCE)) continue
      const [a, b, c] = cornersOf(this.#surface, triangle)
      interpolate(position, this.#surface.points, 3, a, b, c, weights[0], weights[1], weights[2])
      const distance = Math.hypot(position[0], position[2] + RADIUS)
      if (distance <= farthest) continue
      farthest = distance
      found = { triangle, position: [position[0], position[1], position[2]] }
    }
    return found
  }

  /** The cosine between a normal and the direction out of the head, and how many millimetres a position is behind the outermost skin. */
  exposure(x: number, y: number, z: number, normal: ArrayLike<number>): { facing: number; depth: number } {
    const rho = Math.hypot(x, z + RADIUS)
    const [outerX, , outerZ] = this.find(unroll(x, y, z))?.position ?? [x, y, z]
    return {
      facing: (normal[0] * x + normal[2] * (z + RADIUS)) / rho,
      depth: Math.hypot(outerX, outerZ + RADIUS) - rho,
    }
  }

  #addToCells(triangle: number): void {
    const [ax, ay, bx, by, cx, cy] = this.#chartTriangle(triangle)
    const [left, right] = [Math.min(ax, bx, cx), Math.max(ax, bx, cx)]
    // The chart is cut at the back of the head.
    if (right - left > RADIUS) return
    const [bottom, top] = [Math.min(ay, by, cy), Math.max(ay, by, cy)]
    for (let row = Math.floor(bottom / CELL); row <= Math.floor(top / CELL); row++) {
      for (let column = Math.floor(left / CELL); column <= Math.floor(right / CELL); column++) {
        const key = row * ROW + column
        const cell = this.#cells.get(key)
        if (cell) cell.push(triangle)
        else this.#cells.set(key, [triangle])
      }
    }
  }

  /** Two chart coordinates for each corner of a triangle. */
  #chartTriangle(triangle: number): number[] {
    return cornersOf(this.#surface, triangle).flatMap((i) => [
      this.#chartPoints[2 * i],
      this.#chartPoints[2 * i + 1],
    ])
  }
}

/** Side of a cell in millimetres, and more columns than a head has. */
const CELL = 6
const ROW = 4096

function cellOf(across: number, up: number): number {
  return Math.floor(up / CELL) * ROW + Math.floor(across / CELL)
}
