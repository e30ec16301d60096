import { smoothstep } from '../../math/scalar.ts'

/** Distance in half widths from which a profile is exactly zero. */
export const REACH = 7

/** Distance in half widths at which the fade to zero begins. */
const FADE_START = 4.5

/**
 * Cross-section of a wrinkle: -(1 - s t) exp(-t), where t is the distance from the bottom in half widths and s the height of the
 * shoulders. A fold of skin is a sharp valley between rounded banks (Harrison, A physics-based model for wrinkling skin, University
 * of British Columbia 2015); among curves of that shape this one has a volume in closed form: its integral over t is -(1 - s), so
 * with s = 1 the banks hold all the skin pushed out of the valley. It is -1 at t = 0, -(1 - s)/e at t = 1 and highest at t = 1 + 1/s.
 *
 * The bottom is rounded by `softness`, which keeps the values at t = 0 and t = 1; the far end fades to exactly 0 at REACH, which
 * takes a tenth off the banks.
 *
 * @param distance from the bottom in half widths, at least 0.
 * @param shoulder s, 0..1.
 * @param softness 0..1, in half widths.
 * @returns the height as a fraction of the depth.
 */
export function profile(distance: number, shoulder: number, softness: number): number {
  if (distance >= REACH) return 0
  // The hypotenuse costs ten times as much.
  const rounded = Math.sqrt(distance * distance + softness * softness) - softness
  const t = rounded / (Math.sqrt(1 + softness * softness) - softness)
  const height = -(1 - shoulder * t) * Math.exp(-t)
  return distance <= FADE_START
    ? height
    : height * (1 - smoothstep((distance - FADE_START) / (REACH - FADE_START)))
}
