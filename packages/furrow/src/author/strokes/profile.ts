import { exp } from '../../math/elementary.ts'
import { smoothstep } from '../../math/scalar.ts'

/** Distance from the valley's bottom at which the depth reaches zero, in units of half the valley's width. */
export const VALLEY_REACH = 5

/** Distance from the valley's bottom at which the depth starts to fade to zero, in the unit of `VALLEY_REACH`. */
const FADE_START = 3

/** Area under the cross-section of a bank (the raised skin beside a valley) with height 1 and width 1. */
const BANK_VOLUME = 9 / 16

/**
 * Computes the depth of a valley at a distance from its bottom: `exp(-t)`, where t is the distance in units of half the valley's width. Skin
 * bends sharply at the bottom and is convex everywhere else (Harrison, A physics-based model for wrinkling skin, University of British
 * Columbia 2015). The cross-section has the area `halfWidth * depth` on each side of the bottom. `softness` rounds the bottom but
 * keeps the depths at t = 0 and t = 1. The depth fades to exactly 0 at `VALLEY_REACH`.
 *
 * @param distance distance from the bottom, at least 0, in units of half the valley's original width.
 * @param softness radius of the rounded bottom, 0..1, in units of half the valley's width after widening.
 * @param widened factor, at least 1, that makes the valley wider and divides its depth, so that the volume stays the same.
 * @returns depth as a fraction of the valley's depth; `1 / widened` at the bottom.
 */
export function valleyAt(distance: number, softness: number, widened = 1): number {
  if (distance >= VALLEY_REACH) return 0
  const t = distance / widened
  // `Math.hypot` would be ten times slower.
  const rounded = Math.sqrt(t * t + softness * softness) - softness
  const depth = exp(-rounded / (Math.sqrt(1 + softness * softness) - softness)) / widened
  return distance <= FADE_START
    ? depth
    : depth * (1 - smoothstep((distance - FADE_START) / (VALLEY_REACH - FADE_START)))
}

/**
 * Computes the height of a bank. It is proportional to `x * (1 - x)^2`, where x is the distance from the valley's bottom as a fraction of
 * `reach`. The bank starts at the bottom, peaks at a third of its reach and ends smoothly. The banks between two parallel valleys that are
 * `reach` apart form one bulge with its crest in the middle (see `HeightSum`). With `shoulder` 1, a bank has the volume of half the valley.
 *
 * @param distance distance from the valley's bottom, at least 0, in units of half the valley's width.
 * @param reach distance from the valley's bottom to the bank's outer end, in the same unit.
 * @returns height as a fraction of the valley's depth.
 */
export function bankAt(distance: number, reach: number, shoulder: number): number {
  if (distance >= reach) return 0
  const x = distance / reach
  return ((27 / 4) * shoulder * x * (1 - x) ** 2) / (BANK_VOLUME * reach)
}

/**
 * Computes the height of a bulge: `(1 - x^2)^2`, where x is the distance from the crest. The crest is round, and the foot is smooth. The slope is
 * at most 1.54 times the height divided by half the width.
 *
 * @param distance distance from the crest, at least 0, in units of half the bulge's width.
 * @returns height as a fraction of the bulge's height.
 */
export function bulgeAt(distance: number): number {
  return distance >= 1 ? 0 : (1 - distance * distance) ** 2
}

/**
 * Returns the steepest slope of a bank's outer flank, for `shoulder` 1. It is at two thirds of the reach.
 *
 * @param depth depth of the valley, in any unit.
 * @param halfWidth half width of the valley, in the same unit.
 * @param reach reach of the bank, in the same unit.
 */
export function bankSlope(depth: number, halfWidth: number, reach: number): number {
  return ((9 / 4) * (depth * halfWidth)) / (BANK_VOLUME * reach ** 2)
}
