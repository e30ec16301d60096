import { lerp } from '../../../math/scalar.ts'
import { strongestBend } from '../anatomy/profile.ts'
import { bezierPath, chartPointOf, type FaceContext, type Side } from '../anatomy/region.ts'
import { type BulgeRegion, unevenness } from './bulge-region.ts'

/** Distances beside the corner of the mouth, in millimetres: front and back end of the jowl. */
const FRONT = 6
const BACK = 33
/** Height of the jowl's crest above the edge of the jaw, in millimetres. */
const ABOVE_JAW = 6.5
/** Range, in millimetres, in which the edge of the jaw is searched: below the corner of the mouth, and below the chin. */
const SEARCHED = [4, 18] as const

/**
 * Returns the jowl: skin and fat that sink over the edge of the jaw beside the chin. In front of the jowl, a ligament holds the
 * skin, and a groove forms (prejowl sulcus).
 */
export function jowl({ landmarks, radiusAt, rngOf }: FaceContext, side: Side, name: string): BulgeRegion {
  const rng = rngOf(`jowl${name}`)
  const [corner, mouth] = chartPointOf(landmarks.mouthCorner)
  const size = unevenness(rng)
  const shift = rng.jitter(2)
  const [front, back] = [corner + FRONT + shift, corner + BACK + shift]
  const edgeAt = (across: number) =>
    strongestBend(
      radiusAt,
      [side * across, mouth - SEARCHED[0]],
      [side * across, landmarks.chin - SEARCHED[1]],
      1,
    )[1]
  const [edgeInFront, edgeBehind] = [edgeAt(front), edgeAt(back)]
  /** Returns a point above the edge of the jaw, at a fraction of the way from the front of the jowl to its back. */
  const above = (fraction: number, height: number) =>
    [lerp(front, back, fraction), lerp(edgeInFront, edgeBehind, fraction) + height] as const
  return {
    name: `jowl${name}`,
    lines: [
      {
        path: bezierPath(
          side,
          above(0, ABOVE_JAW + 1),
          above(0.33, ABOVE_JAW - 0.5),
          above(0.67, ABOVE_JAW),
          above(1, ABOVE_JAW + 2),
        ),
        width: 25,
        height: 3 * size,
        // The jowl is fullest behind the groove.
        heights: [0.8, 1, 0.85, 0.55, 0.25],
        taper: [0.5, 0.6],
      },
      {
        path: bezierPath(
          side,
          [corner + 1, mouth - 14],
          [corner + 2.5, mouth - 19],
          above(-0.15, ABOVE_JAW + 2),
          above(-0.1, 1),
        ),
        width: 11,
        height: -0.5 * size,
        taper: [0.5, 0.4],
      },
    ],
  }
}
