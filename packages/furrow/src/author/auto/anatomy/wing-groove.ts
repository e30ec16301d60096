import { median } from '../../../math/quantile.ts'
import { strongestBend } from './profile.ts'
import type { FaceContext, Side } from './region.ts'

/** Distance from the middle of the face to the cheek beside the nose, in millimetres. */
const CHEEK = 40
/** Vertical distances, in millimetres, of the profiles whose median is taken. */
const ROWS = [-3, -1.5, 0, 1.5, 3] as const

/**
 * Finds the groove between the wing of the nose and the cheek: the strongest bend of the surface between the ridge of the nose and the cheek.
 *
 * @param up height of the profile on the head's chart.
 * @returns distance from the middle of the face on the chart, in millimetres, positive on both sides.
 */
export function wingGroove({ radiusAt }: Pick<FaceContext, 'radiusAt'>, side: Side, up: number): number {
  return median(
    ROWS.map((row) => Math.abs(strongestBend(radiusAt, [0, up + row], [side * CHEEK, up + row], -1)[0])),
  )
}
