import { exp } from '../../math/elementary.ts'
import { length } from '../../math/vector.ts'
import type { SkinSurface } from '../skin/surface.ts'
import type { SkinLine } from '../strokes/curve.ts'

/** Fade distance of a line's direction, and spacing of its samples, in millimetres. */
const FADE = 12
const SAMPLE_SPACING = 3
/** Cutoff in fade distances: beyond it weights are below 1/1000. */
const CUTOFF = 2.7
/** Weight of having no direction, in weights of a line sample: far from lines furrows run any way. */
const NO_DIRECTION = 0.05
/** Count of numbers in a symmetric matrix: xx, yy, zz, xy, xz, yz. */
export const TENSOR = 6
/** Count of numbers per line sample: position and tangent. */
const SAMPLE = 6

/**
 * Computes the direction along lines at each point of a skin: distance-weighted means of the matrices t t^T of the lines' tangents t,
 * which have no sign. The trace is 1 on a line and falls to 0 far from all lines.
 */
export function directionsAlong({ points }: SkinSurface, lines: readonly SkinLine[]): Float64Array {
  const samples = Float64Array.from(lines.flatMap(samplesOf))
  const count = points.length / 3
  const field = new Float64Array(count * TENSOR)
  const sum = new Float64Array(TENSOR)
  for (let point = 0; point < count; point++) {
    const [x, y, z] = [points[3 * point], points[3 * point + 1], points[3 * point + 2]]
    sum.fill(0)
    let total = NO_DIRECTION
    for (let i = 0; i < samples.length; i += SAMPLE) {
      const dx = samples[i] - x
      const dy = samples[i + 1] - y
      const dz = samples[i + 2] - z
      const square = dx * dx + dy * dy + dz * dz
      if (square > (CUTOFF * FADE) ** 2) continue
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

/** Samples positions and unit tangents every few millimetres, `SAMPLE` numbers each. */
function samplesOf({ points }: SkinLine): number[] {
  const samples: number[] = []
  let since = SAMPLE_SPACING
  for (let i = 0; i + 5 < points.length; i += 3) {
    const step = [0, 1, 2].map((k) => points[i + 3 + k] - points[i + k])
    const moved = length(step)
    since += moved
    if (moved === 0 || since < SAMPLE_SPACING) continue
    since = 0
    samples.push(...points.subarray(i, i + 3), ...step.map((value) => value / moved))
  }
  return samples
}
