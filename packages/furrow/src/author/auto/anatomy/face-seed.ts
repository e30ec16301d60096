import { hash32 } from '../../../math/hash.ts'
import type { Landmarks } from '../surface/landmarks.ts'

/** Distances are rounded to multiples of this value, in millimetres, because mesh compression moves landmarks slightly. */
const STEP = 2

/**
 * Derives a random seed from the proportions of a face, so that different people get different lines. If vertex positions are quantised to
 * 14 bits, the distances used here change by less than 0.05 mm. The heights of brows and chin change by 0.3 mm, so they are not used.
 *
 * @param landmarks positions in millimetres, on a head that is scaled so that the eyes are 63 mm apart.
 * @returns an integer, 0..2^31 - 1.
 */
export function faceSeed(landmarks: Landmarks): number {
  const { eye, outerCorner, mouthCorner, tip, wing, noseBase } = landmarks
  const distances = [
    outerCorner[0],
    mouthCorner[0],
    eye[1] - mouthCorner[1],
    tip[2] - eye[2],
    wing[0],
    eye[1] - noseBase,
  ]
  const seed = distances.reduce((hash, distance) => hash32(hash + Math.round(distance / STEP)), 0)
  return seed >>> 1
}
