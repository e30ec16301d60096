import { exp } from '../../math/elementary.ts'
import { smoothstep } from '../../math/scalar.ts'

/** Distance from the valley's bottom at which the depth reaches zero, in units of half the valley's width. */
export const VALLEY_REACH = 5

/** Distance at which the fade to zero begins, in the same unit. */
const FADE_START = 3

/** Area under the cross-section of a bank with height 1 and reach 1. */
const BANK_VOLUME = 9 / 16

/**
 * Computes the cross-section of a valley without banks: `exp(-t)`, where t is the distance from the bottom in units of half the valley's
 * width. Skin bends sharply at the bottom and is convex everywhere else (Harrison, A physics-based model for wrinkling skin, University of
 * British Columbia 2015). The cross-section has the area `halfWidth * depth` on each side of the bottom. `softness` rounds the bottom but
 * keeps the depths at t = 0 and t = 1. The depth fades to exactly 0 at `VALLEY_REACH`.
 *
 * @param distance distance from the bottom, at least 0, in units of half the valley's width before it is widened.
 * @param softness radius of the rounded bottom, 0..1, in units of half the width of the drawn valley.
 * @param widened factor, at least 1, that makes the valley wider and divides its depth, so that the volume stays the same.
 * @returns depth as a fraction of the valley's depth; `1 / widened` at the bottom.
 */
export function valleyAt(distance: number, softness: number, widened = 1): number {
  if (distance >= VALLEY_REACH) return 0
  const t = distance / widened
  // Math.hypot is ten times slower.
  const rounded = Math.sqrt(t * t + softness * softness) - softness
  const depth = exp(-rounded / (Math.sqrt(1 + softness * softness) - softness)) / widened
  return distance <= FADE_START
    ? depth
    : depth * (1 - smoothstep((distance - FADE_START) / (VALLEY_REACH - FADE_START)))
}

/**
 * Computes the cross-section of a bank. It is proportional to `x * (1 - x)^2`, with x the distance from the valley's bottom as a fraction of
 * the bank's reach. The bank starts at the bottom, peaks at a third of its reach and ends smoothly. If two valleys are one reach apart, their
 * banks add up to the parabola `x * (1 - x)`: one convex bulge. A bank with `shoulder` 1 has the same volume as its side of the valley.
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
 * Returns the steepest outer slope of a bank with `shoulder` 1, at two thirds of its reach.
 *
 * @param depth depth of the valley, in any unit.
 * @param halfWidth half width of the valley, in the same unit.
 * @param reach reach of the bank, in the same unit.
 */
export function bankSlope(depth: number, halfWidth: number, reach: number): number {
  return ((9 / 4) * (depth * halfWidth)) / (BANK_VOLUME * reach ** 2)
}
