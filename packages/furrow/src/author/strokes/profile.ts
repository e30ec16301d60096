import { exp } from '../../math/elementary.ts'
import { smoothstep } from '../../math/scalar.ts'

/** Distance in half widths from which the valley is exactly zero. */
export const VALLEY_REACH = 5

/** Distance in half widths at which its fade to zero begins. */
const FADE_START = 3

/** Volume under a bank of height and reach 1. */
const BANK_VOLUME = 9 / 16

/**
 * Cross-section of a wrinkle without its banks: exp(-t), where t is the distance from the bottom in half widths. Skin bends sharply at the
 * bottom and is convex everywhere else (Harrison, A physics-based model for wrinkling skin, University of British Columbia 2015). The volume
 * of a side, in half widths times the depth, is 1.
 *
 * The bottom is rounded by `softness`, which keeps the values at t = 0 and t = 1; the far end fades to exactly 0 at VALLEY_REACH.
 *
 * @param distance from the bottom in half widths, at least 0.
 * @param softness 0..1, in half widths as drawn.
 * @param widened how many times as wide it is drawn, and so as shallow: its volume stays. At least 1.
 * @returns the depth below the banks, 1 / widened at the bottom.
 */
export function valleyAt(distance: number, softness: number, widened = 1): number {
  if (distance >= VALLEY_REACH) return 0
  const t = distance / widened
  // The hypotenuse costs ten times as much.
  const rounded = Math.sqrt(t * t + softness * softness) - softness
  const depth = exp(-rounded / (Math.sqrt(1 + softness * softness) - softness)) / widened
  return distance <= FADE_START
    ? depth
    : depth * (1 - smoothstep((distance - FADE_START) / (VALLEY_REACH - FADE_START)))
}

/**
 * Cross-section of a bank: x (1 - x)^2, where x is the distance from the bottom as a fraction of the bank's reach. It rises from the bottom
 * at once, is highest at a third of its reach and ends without an edge. Where two lines are as far apart as their banks reach, the two add
 * up to the parabola x (1 - x): one convex bulge from valley to valley.
 *
 * Its height is such that banks with `shoulder` 1 hold all the skin pushed out of a valley of half width 1 and depth 1.
 *
 * @param distance from the bottom in half widths, at least 0.
 * @param reach in half widths.
 * @returns the height as a fraction of the valley's depth.
 */
export function bankAt(distance: number, reach: number, shoulder: number): number {
  if (distance >= reach) return 0
  const x = distance / reach
  return ((27 / 4) * shoulder * x * (1 - x) ** 2) / (BANK_VOLUME * reach)
}

/**
 * The steepest slope of a bank with `shoulder` 1 towards its end, at two thirds of its reach.
 *
 * @param depth, halfWidth of the valley, and the bank's reach, all in the same unit.
 */
export function bankSlope(depth: number, halfWidth: number, reach: number): number {
  return ((9 / 4) * (depth * halfWidth)) / (BANK_VOLUME * reach ** 2)
}
