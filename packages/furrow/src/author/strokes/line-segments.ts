import { length2 } from '../../math/vector.ts'
import type { SkinLine } from './curve.ts'

/** Factor that makes a computed distance a lower bound of the exact one, despite rounding errors. */
const ROUNDED = 1 - 1e-6
/** A line affects skin only if the cosine between their normals is at least this. A line on one lip therefore does not affect the other lip. */
export const FACING = 0.25
/** Numbers per segment: start, vector to its end, inverse of its squared length, normal. */
const STRIDE = 10

/** Segments of lines on the skin, packed into arrays for fast distance queries. Positions are in millimetres. */
export class LineSegments {
  /** Index of each segment's line. */
  readonly lineOf: Int32Array
  /** Index of each segment's start point in its line. */
  readonly pointOf: Int32Array
  /** All segments, as one run of successive indices per line. A run is a pair of numbers: its first index, and its last index plus 1. */
  readonly runs: Int32Array
  readonly #numbers: Float64Array
  /** Length of the longest segment of each line in millimetres. */
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

  /** Returns the fraction of a segment's length, 0..1, at which the segment is nearest to a position. */
  fractionAt(segment: number, px: number, py: number, pz: number): number {
    const s = this.#numbers
    const k = STRIDE * segment
    const along =
      (s[k + 3] * (px - s[k]) + s[k + 4] * (py - s[k + 1]) + s[k + 5] * (pz - s[k + 2])) * s[k + 6]
    return along < 0 ? 0 : along > 1 ? 1 : along
  }

  /** Returns whether a segment's normal is within about 75 degrees of a unit normal of the skin. */
  faces(segment: number, nx: number, ny: number, nz: number): boolean {
    const s = this.#numbers
    const k = STRIDE * segment
    return s[k + 7] * nx + s[k + 8] * ny + s[k + 9] * nz >= FACING
  }

  /**
   * Returns -1 if a position is left of a segment, 1 if it is right. Around an end of the line, returns the sine of the angle between the
   * segment and the direction from that end to the position. Both are projected onto the tangent plane of the segment.
   *
   * @param t result of `fractionAt` for the same segment and position.
   */
  sideOf(segment: number, x: number, y: number, z: number, t: number): number {
    const s = this.#numbers
    const k = STRIDE * segment
    const vx = x - s[k]
    const vy = y - s[k + 1]
    const vz = z - s[k + 2]
    // `dot(normal, cross(segment, position - start))` is positive on the left. `left` and `beyond` are distances times the segment's length.
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
   * Returns how many segments a search can advance. All segments that it skips are farther than `distance` from a position.
   *
   * @param square squared distance from the position to the current segment.
   */
  stepsTo(line: number, square: number, distance: number): number {
    const segments = (ROUNDED * Math.sqrt(square) - distance) / this.#longest[line]
    return segments > 1 ? Math.ceil(segments) : 1
  }

  /** Returns the minimum squared distance for which `stepsTo` exceeds 1. Comparing with it is cheaper than calling `stepsTo`. */
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
