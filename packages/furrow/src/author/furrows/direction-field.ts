import { exp } from '../../math/elementary.ts'
import { length } from '../../math/vector.ts'
import type { SkinSurface } from '../skin/surface.ts'
import type { SkinLine } from '../strokes/curve.ts'

/** Millimetres over which a line's direction fades, and between the points of lines that count. */
const FADE = 12
const EVERY = 3
/** Fadings from which on a line does not count: its weight is below 1/1000. */
const FARTHEST = 2.7
/** Weight of having no direction, per line point: far from lines furrows run any way. */
const NONE = 0.05
/** Numbers of a symmetric matrix: xx, yy, zz, xy, xz, yz. */
export const TENSOR = 6
/** Numbers of a point of a line: its position and tangent. */
const SAMPLE = 6

/**
 * Directions along lines, at each point of a skin: means of the matrices t t^T of their tangents t, which have no sign, weighted by distance. The
 * trace is 1 on a line and falls to 0 far from all.
 */
export function directionsAlong({ points }: SkinSurface, lines: readonly SkinLine[]): Float64Array {
  const samples = Float64Array.from(lines.flatMap(samplesOf))
  const count = points.length / 3
  const field = new Float64Array(count * TENSOR)
  const sum = new Float64Array(TENSOR)
  for (let point = 0; point < count; point++) {
    const [x, y, z] = [points[3 * point], points[3 * point + 1], points[3 * point + 2]]
    sum.fill(0)
    let total = NONE
    for (let i = 0; i < samples.length; i += SAMPLE) {
      const dx = samples[i] - x
      const dy = samples[i + 1] - y
      const dz = samples[i + 2] - z
      const square = dx * dx + dy * dy + dz * dz
      if (square > (FARTHEST * FADE) ** 2) continue
      const weight = exp(-square / FADE ** 2)
      const tx = samples[i + 3]
      const ty = samples[i + 4]
      const tz = samples[i + 5]
      total += weight
      sum[0] += weight * tx * tx
      sum[1] += weight * ty * ty
      sum[2] += weight * tz * tz
      sum[3] += weight * tx * ty
      sum[4] += weight * tx * tz
      sum[5] += weight * ty * tz
    }
    for (let k = 0; k < TENSOR; k++) field[TENSOR * point + k] = sum[k] / total
  }
  return field
}

/** Positions and unit tangents every few millimetres, `SAMPLE` numbers each. */
function samplesOf({ points }: SkinLine): number[] {
  const samples: number[] = []
  let since = EVERY
  for (let i = 0; i + 5 < points.length; i += 3) {
    const step = [0, 1, 2].map((k) => points[i + 3 + k] - points[i + k])
    const moved = length(step)
    since += moved
    if (moved === 0 || since < EVERY) continue
    since = 0
    samples.push(...points.subarray(i, i + 3), ...step.map((value) => value / moved))
  }
  return samples
}
