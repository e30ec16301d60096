import { smoothstep } from '../../../math/scalar.ts'
import type { HeadChart } from '../surface/head-chart.ts'

/** Depth in millimetres below other skin at which a position starts to be hidden, and the range until fully hidden. */
const HIDDEN_FROM = 0.5
const HIDDEN_OVER = 1
/** Cosines between the normal and the head's outward direction at which skin is invisible, and fully visible. */
const FACING = [-0.1, 0.1] as const

/**
 * Returns how visible a position on the skin is from outside the head, 0..1: 0 in the mouth and on lid rims, where nothing creases.
 *
 * @param normal of the skin there.
 */
export function visibility(
  chart: HeadChart,
  x: number,
  y: number,
  z: number,
  normal: ArrayLike<number>,
): number {
  const { facing, depth } = chart.exposure(x, y, z, normal)
  const turned = smoothstep((facing - FACING[0]) / (FACING[1] - FACING[0]))
  return turned * (1 - smoothstep((depth - HIDDEN_FROM) / HIDDEN_OVER))
}
