import { smoothstep } from '../../../math/scalar.ts'
import type { HeadChart } from '../surface/head-chart.ts'

/** Skin starts to be hidden at this depth below other skin, in millimetres. */
const HIDDEN_FROM = 0.5
/** Skin is completely hidden at the depth `HIDDEN_FROM` plus this, in millimetres. */
const HIDDEN_OVER = 1
/** Cosines between the normal and the outward direction of the head: at the first one skin is hidden, at the second one visible. */
const FACING = [-0.1, 0.1] as const

/**
 * Returns how visible a position on the skin is from outside the head, 0..1. The result is 0 inside the mouth and on the rims of lids, so that
 * no wrinkles are drawn there.
 *
 * @param normal normal of the skin at the position.
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
