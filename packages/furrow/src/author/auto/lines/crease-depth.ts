import { clamp } from '../../../math/scalar.ts'
import { addSection, HeightSum } from '../../strokes/height-sum.ts'
import { type CrossSection, sectionReach } from '../../strokes/lay-out.ts'

const STEPS = 256
/** Number of bisections of the depth range. They resolve a thousandth of a millimetre. */
const BISECTIONS = 16

/**
 * Computes the depth at which valleys take up the length that compressed skin loses. A length dx of skin at rest shrinks to `(1 - e) * dx`, but
 * the profile of the wrinkled skin must still have the length dx. So the mean of `sqrt((1 - e)^2 + h'^2)` over one spacing must be 1, where
 * h' is the slope of the profile.
 *
 * @param compression lost fraction e of the length, 0..1.
 * @param spacing distance between lines in millimetres.
 * @param halfWidth half width of a valley in millimetres.
 */
export function creaseDepth(
  compression: number,
  spacing: number,
  halfWidth: number,
  section: CrossSection,
): number {
  const left = 1 - clamp(compression, 0, 1)
  const heights = heightsBetween(spacing, halfWidth, section)
  const slopes = heights.slice(1).map((height, i) => ((height - heights[i]) * STEPS) / spacing)
  const length = (depth: number) =>
    slopes.reduce((sum, slope) => sum + Math.sqrt(left ** 2 + (depth * slope) ** 2), 0) / STEPS
  let [low, high] = [0, 2 * spacing]
  for (let i = 0; i < BISECTIONS; i++) {
    const middle = (low + high) / 2
    if (length(middle) < 1) low = middle
    else high = middle
  }
  return low
}

/** Returns the profile of many parallel lines with depth 1, from one line to the next. */
function heightsBetween(spacing: number, halfWidth: number, section: CrossSection): number[] {
  const sum = new HeightSum()
  const lines = 1 + Math.ceil((sectionReach(section) * halfWidth) / spacing)
  return Array.from({ length: STEPS + 1 }, (_, i) => {
    sum.clear()
    for (let line = -lines; line <= lines; line++) {
      const offset = spacing * (i / STEPS - line)
      addSection(sum, section, 1, halfWidth, Math.abs(offset), Math.sign(offset), 0)
    }
    return sum.height
  })
}
