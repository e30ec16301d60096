import { length2 } from '../../math/vector.ts'
import type { SkinLine } from './curve.ts'

/** Factor that keeps a distance a lower bound after rounding. */
const ROUNDED = 1 - 1e-6
/** Minimum cosine between normals of points that face the same way: separates the upper from the lower lip. */
const FACING = 0.25
/** Numbers per segment: start, vector to its end, inverse of its squared length, normal. */
const STRIDE = 10

/** Segments of lines on the skin, packed for tight loops. Positions are in millimetres. */
export class LineSegments {
  /** Line and start point of each segment. */
  readonly lineOf: Int32Array
  readonly pointOf: Int32Array
  /** All segments as runs: pairs of first index and end index (exclusive), one run per line. */
  readonly runs: Int32Array
  readonly #numbers: Float64Array
  /** Longest segment of each line in millimetres. */
  readonly #longest: Float64Array

  constructor(lines: readonly SkinLine[]) {
    const total = lines.reduce((sum, { points }) => sum + Math.max(0, points.length / 3 - 1), 0)
    this.lineOf = new Int32Array(total)
    this.pointOf = new Int32Array(total)
    this.#numbers = new Float64Array(STRIDE * total)
    this.#longest = new Float64Array(lines.length)
    const runs: number[] = []
    let segment = 0
    for (const [line, { points, normals }] of lines.entries()) {
      const first = segment
      for (let point = 0; point + 1 < points.length / 3; point++) {
        this.lineOf[segment] = line
        this.pointOf[segment] = point
        this.#store(segment++, points, normals)
      }
      if (segment > first) runs.push(first, segment)
    }
    this.runs = Int32Array.from(runs)
  }

  /** Returns the squared distance from a position to a segment. */
  squareTo(segment: number, px: number, py: number, pz: number): number {
    const s = this.#numbers
    const k = STRIDE * segment
    const x = px - s[k]
    const y = py - s[k + 1]
    const z = pz - s[k + 2]
    const along = (s[k + 3] * x + s[k + 4] * y + s[k + 5] * z) * s[k + 6]
    const t = along < 0 ? 0 : along > 1 ? 1 : along
    const dx = x - t * s[k + 3]
    const dy = y - t * s[k + 4]
    const dz = z - t * s[k + 5]
    return dx * dx + dy * dy + dz * dz
  }

  /** Returns the position along a segment nearest to a point, 0..1. */
  fractionAt(segment: number, px: number, py: number, pz: number): number {
    const s = this.#numbers
    const k = STRIDE * segment
    const along =
      (s[k + 3] * (px - s[k]) + s[k + 4] * (py - s[k + 1]) + s[k + 5] * (pz - s[k + 2])) * s[k + 6]
    return along < 0 ? 0 : along > 1 ? 1 : along
  }

  /** Returns whether a segment faces the same way as the skin with this normal. */
  faces(segment: number, nx: number, ny: number, nz: number): boolean {
    const s = this.#numbers
    const k = STRIDE * segment
    return s[k + 7] * nx + s[k + 8] * ny + s[k + 9] * nz >= FACING
  }

  /**
   * Returns the sine, in the tangent plane, between the segment and the direction to a position: 1 to its right, -1 to its left, less
   * around its ends. The height above the tangent plane is ignored, because skin is curved.
   *
   * @param t result of `fractionAt`.
   */
  sideOf(segment: number, x: number, y: number, z: number, t: number): number {
    const s = this.#numbers
    const k = STRIDE * segment
    const vx = x - s[k]
    const vy = y - s[k + 1]
    const vz = z - s[k + 2]
    // Both are scaled by the segment's length. (segment x offset) . normal is positive on the left.
    const left =
      s[k + 7] * (s[k + 4] * vz - s[k + 5] * vy) +
      s[k + 8] * (s[k + 5] * vx - s[k + 3] * vz) +
      s[k + 9] * (s[k + 3] * vy - s[k + 4] * vx)
    const isEnd =
      t > 0 ? t === 1 && this.lineOf[segment + 1] !== this.lineOf[segment] : this.pointOf[segment] === 0
    if (!isEnd) return -Math.sign(left)
    const beyond = s[k + 3] * vx + s[k + 4] * vy + s[k + 5] * vz - (t > 0 ? 1 / s[k + 6] : 0)
    return left === 0 ? 0 : -left / length2(left, beyond)
  }

  /**
   * Returns the number of segments to skip to the next one that may be within `distance`, given the squared distance to the current one.
   */
  stepsTo(line: number, square: number, distance: number): number {
    const segments = (ROUNDED * Math.sqrt(square) - distance) / this.#longest[line]
    return segments > 1 ? Math.ceil(segments) : 1
  }

  /** Returns the squared distance beyond which `stepsTo` skips segments of a line: cheaper to compare. */
  farFrom(line: number, distance: number): number {
    return ((distance + this.#longest[line]) / ROUNDED) ** 2
  }

  #store(segment: number, points: Float64Array, normals: Float64Array): void {
    const start = 3 * this.pointOf[segment]
    let square = 0
    for (let k = 0; k < 3; k++) {
      const component = points[start + 3 + k] - points[start + k]
      this.#numbers[STRIDE * segment + k] = points[start + k]
      this.#numbers[STRIDE * segment + 3 + k] = component
      this.#numbers[STRIDE * segment + 7 + k] = normals[start + k]
      square += component * component
    }
    this.#numbers[STRIDE * segment + 6] = square > 0 ? 1 / square : 0
    const line = this.lineOf[segment]
    this.#longest[line] = Math.max(this.#longest[line], Math.sqrt(square))
  }
}
