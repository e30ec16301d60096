import { clamp } from '../../../math/scalar.ts'
import { profile, REACH } from '../../strokes/profile.ts'

/** Step along a valley's side, in half widths. */
const STEP = 0.02
/** Bisections of the range of depths: to a thousandth of a millimetre. */
const BISECTIONS = 16

/**
 * Depth of a valley that takes up the length that skin loses: of a length dx at rest (1 - e) dx is left, over which the relief must be dx
 * long, so the mean of sqrt((1 - e)^2 + h'^2) over one spacing is 1.
 *
 * @param compression e, 0..1.
 * @param spacing from line to line, and half the width of a valley, in millimetres.
 */
export function creaseDepth(
  compression: number,
  spacing: number,
  halfWidth: number,
  shoulder: readonly [left: number, right: number],
  softness: number,
): number {
  const left = 1 - clamp(compression, 0, 1)
  const end = Math.min(REACH, spacing / (2 * halfWidth))
  const steps = Math.ceil(end / STEP)
  const slopes = shoulder.flatMap((raised) =>
    Array.from({ length: steps }, (_, i) => {
      const [from, to] = [(end * i) / steps, (end * (i + 1)) / steps]
      return (profile(to, raised, softness) - profile(from, raised, softness)) / ((to - from) * halfWidth)
    }),
  )
  // Beyond the reach of the valley the skin is flat, and shortened nevertheless.
  const covered = (2 * end * halfWidth) / spacing
  const length = (depth: number) =>
    (covered * slopes.reduce((sum, slope) => sum + Math.hypot(left, depth * slope), 0)) / slopes.length +
    (1 - covered) * left
  let [low, high] = [0, 2 * spacing]
  for (let i = 0; i < BISECTIONS; i++) {
    const middle = (low + high) / 2
    if (length(middle) < 1) low = middle
    else high = middle
  }
  return low
}
