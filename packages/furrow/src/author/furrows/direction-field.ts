import type { SkinSurface } from '../skin/surface.ts'
import type { SkinLine } from '../strokes/curve.ts'

/** Millimetres over which a line's direction fades, and between the points of lines that count. */
const FADE = 12
const EVERY = 3
/** Weight of having no direction, per line point: far from lines furrows run any way. */
const NONE = 0.05
/** Numbers of a symmetric matrix: xx, yy, zz, xy, xz, yz. */
export const TENSOR = 6

/**
 * Directions along lines, at each point of a skin: means of the matrices t t^T of their tangents t, which have no sign, weighted by distance. The
 * trace is 1 on a line and falls to 0 far from all.
 */
export function directionsAlong({ points }: SkinSurface, lines: readonly SkinLine[]): Float64Array {
  const samples = lines.flatMap(samplesOf)
  const field = new Float64Array((points.length / 3) * TENSOR)
  for (let point = 0; point < points.length / 3; point++) {
    const [x, y, z] = [points[3 * point], points[3 * point + 1], points[3 * point + 2]]
    let total = NONE
    for (const [sx, sy, sz, tx, ty, tz] of samples) {
      const weight = Math.exp(-((sx - x) ** 2 + (sy - y) ** 2 + (sz - z) ** 2) / FADE ** 2)
      total += weight
      field[TENSOR * point] += weight * tx * tx
      field[TENSOR * point + 1] += weight * ty * ty
      field[TENSOR * point + 2] += weight * tz * tz
      field[TENSOR * point + 3] += weight * tx * ty
      field[TENSOR * point + 4] += weight * tx * tz
      field[TENSOR * point + 5] += weight * ty * tz
    }
    for (let k = 0; k < TENSOR; k++) field[TENSOR * point + k] /= total
  }
  return field
}

/** Positions and unit tangents every few millimetres. */
function samplesOf({ points }: SkinLine): number[][] {
  const samples: number[][] = []
  let since = EVERY
  for (let i = 0; i + 5 < points.length; i += 3) {
    const step = [0, 1, 2].map((k) => points[i + 3 + k] - points[i + k])
    const length = Math.hypot(...step)
    since += length
    if (length === 0 || since < EVERY) continue
    since = 0
    samples.push([...points.subarray(i, i + 3), ...step.map((value) => value / length)])
  }
  return samples
}
