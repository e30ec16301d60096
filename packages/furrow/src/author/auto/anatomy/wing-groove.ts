import { median } from '../../../math/quantile.ts'
import type { FaceContext, Side } from './region.ts'

/** Range of distances from the middle of the face in which the groove is searched, and step of the search, in millimetres. */
const [FROM, TO, STEP] = [8, 34, 0.5]
/** Distance, in millimetres, between the points of a profile whose second difference is its bend. */
const SPAN = 3
/** Bends that are at least this fraction of the sharpest one determine the groove. Their mean changes continuously with the surface. */
const PEAK = 0.8
/** Vertical distances, in millimetres, of the profiles whose median is taken. */
const ROWS = [-3, -1.5, 0, 1.5, 3] as const

/**
 * Finds the groove between the wing of the nose and the cheek: the sharpest inward bend of the surface beside the nose.
 *
 * @param up height of the profile on the head's chart.
 * @returns distance from the middle of the face on the chart, in millimetres, positive on both sides.
 */
export function wingGroove({ radiusAt }: Pick<FaceContext, 'radiusAt'>, side: Side, up: number): number {
  const count = (TO - FROM) / STEP + 1
  const places = Array.from({ length: count }, (_, i) => FROM + STEP * i)
  return median(
    ROWS.map((row) => {
      const radius = (across: number) => radiusAt([side * across, up + row])
      const bends = places.map((across) => {
        const [before, here, after] = [radius(across - SPAN), radius(across), radius(across + SPAN)]
        return before === undefined || here === undefined || after === undefined
          ? 0
          : before + after - 2 * here
      })
      const least = PEAK * Math.max(0, ...bends)
      const weights = bends.map((bend) => Math.max(0, bend - least))
      const total = weights.reduce((a, b) => a + b, 0)
      if (total === 0) return (FROM + TO) / 2
      return places.reduce((sum, across, i) => sum + across * weights[i], 0) / total
    }),
  )
}
