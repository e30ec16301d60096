import { smoothstep } from '../../math/scalar.ts'

/** Distance in half widths at which a profile is exactly zero. */
export const REACH = 7

/** Where the far end of a profile starts to be faded out, in half widths. */
const FADE = 4.5

/**
 * Cross-section of a wrinkle: -(1 - s t) exp(-t), where t is the distance from the bottom in half widths and
 * s the height of the raised sides. A fold of skin is a sharp valley between rounded banks (Harrison, A
 * physics-based model for wrinkling skin, University of British Columbia 2015); of the curves with that look
 * this one keeps the volume in closed form: its integral over t is -(1 - s), so with s = 1 all skin pushed out
 * of the valley lies on the banks. It is -1 at t = 0, -(1 - s)/e at t = 1 and highest at t = 1 + 1/s.
 *
 * The distance is first rounded off near the bottom by `softness` (0..1, in half widths), which keeps the
 * values at t = 0 and t = 1, and the far end is faded to exactly 0 at REACH, which takes a tenth off the banks.
 * `distance` is in half widths, at least 0. Returns the height as a share of the depth.
 */
export function profile(distance: number, shoulder: number, softness: number): number {
  if (distance >= REACH) return 0
  const t = (Math.hypot(distance, softness) - softness) / (Math.hypot(1, softness) - softness)
  const height = -(1 - shoulder * t) * Math.exp(-t)
  return distance <= FADE ? height : height * (1 - smoothstep((distance - FADE) / (REACH - FADE)))
}
