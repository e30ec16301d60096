import type { Surface } from './surface.ts'

/** Millimetres from the surface of the face to the axis of the head. */
const RADIUS = 85

/** A place of the unrolled face: millimetres to the person's left round the head, and upwards. */
export type Spot = readonly [across: number, up: number]

/** A place on the surface. */
export interface SurfacePlace {
  triangle: number
  point: [number, number, number]
}

/** Where a point of the face's frame lies once the head is unrolled from a cylinder. */
export function unroll(x: number, y: number, z: number): Spot {
  return [RADIUS * Math.atan2(x, z + RADIUS), y]
}

/**
 * The direction on the skin that a direction of the unrolled face stands for.
 *
 * @param out takes it, of length 1.
 */
export function rollUp(
  x: number,
  z: number,
  normal: ArrayLike<number>,
  [across, up]: Spot,
  out: Float64Array,
): void {
  const rho = Math.hypot(x, z + RADIUS)
  const [sine, cosine] = [x / rho, (z + RADIUS) / rho]
  const [nx, ny, nz] = [normal[0]!, normal[1]!, normal[2]!]
  const [vx, vy, vz] = [across * cosine, up, -across * sine]
  const facing = nx * sine + nz * cosine
  const rise = nx * vx + ny * vy + nz * vz
  // Along the ray from the axis, as the chart is projected; where skin is seen edge on, straight onto it.
  const isSteep = facing < 0.2
  const [rx, ry, rz, lift] = isSteep ? [nx, ny, nz, rise] : [sine, 0, cosine, rise / facing]
  out[0] = vx - lift * rx
  out[1] = vy - lift * ry
  out[2] = vz - lift * rz
  const length = Math.hypot(out[0]!, out[1]!, out[2]!) || 1
  for (let k = 0; k < 3; k++) out[k]! /= length
}

/** Finds the skin at places of the unrolled face: the outermost where it lies in folds. */
export class Chart {
  readonly #surface: Surface
  readonly #spots: Float64Array
  /** Triangles by the cell of the chart that they touch. */
  readonly #cells = new Map<number, number[]>()

  constructor(surface: Surface) {
    this.#surface = surface
    const { points, corners } = surface
    this.#spots = new Float64Array((points.length / 3) * 2)
    for (let i = 0; i < points.length / 3; i++) {
      const [across, up] = unroll(points[3 * i]!, points[3 * i + 1]!, points[3 * i + 2]!)
      this.#spots[2 * i] = across
      this.#spots[2 * i + 1] = up
    }
    for (let t = 0; t < corners.length / 3; t++) this.#file(t)
  }

  /** @returns undefined where there is no skin. */
  find([across, up]: Spot): SurfacePlace | undefined {
    const { points, corners } = this.#surface
    let found: SurfacePlace | undefined
    let farthest = -Infinity
    for (const triangle of this.#cells.get(cellOf(across, up)) ?? []) {
      const shares = this.#sharesIn(triangle, across, up)
      if (!shares) continue
      const point = [0, 1, 2].map((k) =>
        shares.reduce((sum, share, j) => sum + share * points[3 * corners[3 * triangle + j]! + k]!, 0),
      ) as [number, number, number]
      const distance = Math.hypot(point[0], point[2] + RADIUS)
      if (distance <= farthest) continue
      farthest = distance
      found = { triangle, point }
    }
    return found
  }

  /** Of a place, the cosine between its normal and the way out of the head, and millimetres that it lies behind the outermost skin. */
  outwards(x: number, y: number, z: number, normal: ArrayLike<number>): { facing: number; behind: number } {
    const rho = Math.hypot(x, z + RADIUS)
    const [ox, , oz] = this.find(unroll(x, y, z))?.point ?? [x, y, z]
    return {
      facing: (normal[0]! * x + normal[2]! * (z + RADIUS)) / rho,
      behind: Math.hypot(ox, oz + RADIUS) - rho,
    }
  }

  #file(triangle: number): void {
    const spots = [0, 1, 2].map((k) => this.#surface.corners[3 * triangle + k]!)
    const across = spots.map((i) => this.#spots[2 * i]!)
    // At the back of the head the chart ends.
    if (Math.max(...across) - Math.min(...across) > RADIUS) return
    const up = spots.map((i) => this.#spots[2 * i + 1]!)
    for (let row = Math.floor(Math.min(...up) / CELL); row <= Math.floor(Math.max(...up) / CELL); row++) {
      const last = Math.floor(Math.max(...across) / CELL)
      for (let column = Math.floor(Math.min(...across) / CELL); column <= last; column++) {
        const key = row * ROW + column
        const cell = this.#cells.get(key)
        if (cell) cell.push(triangle)
        else this.#cells.set(key, [triangle])
      }
    }
  }

  /** Shares of a triangle's corners at a spot, undefined outside of it. */
  #sharesIn(triangle: number, across: number, up: number): number[] | undefined {
    const [a, b, c] = [0, 1, 2].map((k) => 2 * this.#surface.corners[3 * triangle + k]!) as [
      number,
      number,
      number,
    ]
    const s = this.#spots
    const [ux, uy, vx, vy] = [s[b]! - s[a]!, s[b + 1]! - s[a + 1]!, s[c]! - s[a]!, s[c + 1]! - s[a + 1]!]
    const [px, py] = [across - s[a]!, up - s[a + 1]!]
    const det = ux * vy - uy * vx
    if (det === 0) return undefined
    const second = (px * vy - py * vx) / det
    const third = (ux * py - uy * px) / det
    const shares = [1 - second - third, second, third]
    return shares.every((share) => share >= -1e-9) ? shares : undefined
  }
}

/** Side of a cell in millimetres. */
const CELL = 6
const ROW = 4096

function cellOf(across: number, up: number): number {
  return Math.floor(up / CELL) * ROW + Math.floor(across / CELL)
}
