import { exp } from '../../math/elementary.ts'
import { length } from '../../math/vector.ts'
import type { SkinSurface } from '../skin/surface.ts'
import type { SkinLine } from '../strokes/curve.ts'

/** Distance in millimetres at which the weight of a line's direction has fallen to 1 / e. */
const FADE = 12
/** Distance between two samples along a line, in millimetres. */
const SAMPLE_SPACING = 3
/** Maximum distance of a sample, as a multiple of `FADE`. Samples farther away are ignored, because their weights are below 1/1000. */
const CUTOFF = 2.7
/** Constant added to the sum of weights. Far from all lines it is larger than the weights, so that the result falls to 0. */
const NO_DIRECTION = 0.05
/** Count of numbers in a symmetric matrix: xx, yy, zz, xy, xz, yz. */
export const TENSOR = 6
/** Count of numbers per line sample: position and tangent. */
const SAMPLE = 6

/**
 * Computes the mean direction of nearby wrinkle lines at each point of the skin. The result is a symmetric matrix per point: the mean of
 * `t * transpose(t)` over the unit tangents t of the lines, weighted by distance. The matrix is the same for t and -t, because a line has no
 * forward direction. The matrix's trace is nearly 1 on a line and falls to 0 far from all lines.
 *
 * @returns `TENSOR` numbers per point.
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

/** Returns positions and unit tangents along a line: `SAMPLE` numbers every `SAMPLE_SPACING` millimetres. */
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
