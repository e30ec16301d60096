import type { ChartPoint } from '../surface/head-chart.ts'
import { chartPointOf, type EyeOpening, type FaceContext, type Side } from './region.ts'

/** Distances in millimetres from the centre of the closed lids in which the opening is searched, and the step. */
const SEARCHED = { above: 4, below: 18, step: 0.5 } as const
/** Distances in millimetres around the corners of the lids in which the opening is searched. */
const BESIDE = 4
/** Minimum width of an opening in millimetres. */
const MIN_WIDTH = 12
/** Usual offsets of the corners and the margin from the landmarks, in millimetres, if the mesh has no hole at the eye. */
const USUAL = { inner: [6.5, -3], outer: [-2, -4], margin: -9 } as const

/** Finds the opening of an eye: the hole of the skin between the lids. The landmarks at the corners are those of the lids, which are wider. */
export function eyeOpening(
  { landmarks, radiusAt }: Pick<FaceContext, 'landmarks' | 'radiusAt'>,
  side: Side,
): EyeOpening {
  const eye = landmarks.eye[1]
  const [inner, innerUp] = chartPointOf(landmarks.innerCorner)
  const [outer, outerUp] = chartPointOf(landmarks.outerCorner)
  let [left, right]: ChartPoint[] = [
    [Infinity, 0],
    [-Infinity, 0],
  ]
  let lowest = Infinity
  for (let up = eye + SEARCHED.above; up >= eye - SEARCHED.below; up -= SEARCHED.step) {
    for (let across = inner - BESIDE; across <= outer + BESIDE; across += SEARCHED.step) {
      if (radiusAt([side * across, up]) !== undefined) continue
      if (across < left[0]) left = [across, up]
      if (across > right[0]) right = [across, up]
      lowest = Math.min(lowest, up)
    }
  }
  if (right[0] - left[0] >= MIN_WIDTH) return { inner: left, outer: right, lowest }
  return {
    inner: [inner + USUAL.inner[0], innerUp + USUAL.inner[1]],
    outer: [outer + USUAL.outer[0], outerUp + USUAL.outer[1]],
    lowest: eye + USUAL.margin,
  }
}
