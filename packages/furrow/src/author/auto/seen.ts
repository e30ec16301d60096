import { smoothstep } from '../../math/scalar.ts'
import type { Chart } from './chart.ts'

/** Millimetres behind other skin at which a place begins to be hidden, and over which it is so altogether. */
const BEHIND = 0.5
const HIDDEN = 1
/** Cosines between normal and the way out of the head, from which on skin is not seen at all and altogether. */
const TURNED = [-0.1, 0.1] as const

/**
 * How far a place is seen from outside the head, 0..1: not in the mouth, nor on the rims of lids, where nothing creases.
 *
 * @param normal of the skin there.
 */
export function seenShare(chart: Chart, x: number, y: number, z: number, normal: ArrayLike<number>): number {
  const { facing, behind } = chart.outwards(x, y, z, normal)
  const turned = smoothstep((facing - TURNED[0]) / (TURNED[1] - TURNED[0]))
  return turned * (1 - smoothstep((behind - BEHIND) / HIDDEN))
}
