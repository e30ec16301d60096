import { atan2, cos, sin } from '../../../math/elementary.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import type { AutoRegion } from './region-names.ts'

/** Facial measurement outside the human range. It makes the landmarks of some regions unreliable. */
export interface ImplausibleMeasure {
  /** Clause for a message, such as "the eyes are 50 mm wide, not 15 to 46". */
  description: string
  /** Regions whose landmarks are unreliable. */
  regions: readonly AutoRegion[]
}

type MeasuredFace = Pick<DetectedFace, 'landmarks' | 'surface'>

interface Measure {
  name: string
  measure: (face: MeasuredFace) => number
  /** Accepted range in millimetres, on heads that are scaled so that the eyes are 63 mm apart. */
  range: readonly [low: number, high: number]
  /** Regions that rely on the measurement. */
  regions: readonly AutoRegion[]
}

/**
 * Facial measurements that regions rely on. An adult's eye is about 31 mm wide, and the nose protrudes by about 20 mm (Farkas 1994,
 * Anthropometry of the Head and Face). The ranges are wide, so that they exclude stylised heads only.
 */
const MEASURES: readonly Measure[] = [
  {
    name: 'the eyes are %s wide',
    measure: ({ landmarks: { innerCorner, outerCorner } }) => outerCorner[0] - innerCorner[0],
    range: [15, 46],
    regions: ['crowsFeet', 'underEye', 'bag', 'hood'],
  },
  {
    name: 'the nose protrudes by %s',
    measure: ({ landmarks: { tip, eye } }) => tip[2] - eye[2],
    range: [12, 70],
    regions: ['nose', 'noseRoot', 'nasolabial', 'cheek'],
  },
  {
    name: 'the mouth is %s below the eyes',
    measure: ({ landmarks: { mouthCorner, eye } }) => eye[1] - mouthCorner[1],
    range: [38, 110],
    regions: ['nasolabial', 'mouthCorner', 'upperLip', 'lowerLip', 'chin', 'neck', 'cheek', 'jowl'],
  },
  {
    name: 'the brows are %s above the eyes',
    measure: ({ landmarks: { innerBrow, outerBrow, eye } }) => (innerBrow[1] + outerBrow[1]) / 2 - eye[1],
    range: [3, 40],
    regions: ['foreheadInner', 'foreheadOuter', 'glabella', 'noseRoot', 'hood'],
  },
  {
    name: 'the mouth protrudes by %s',
    measure: muzzleOf,
    range: [-40, 15],
    regions: ['nose', 'nasolabial', 'mouthCorner', 'upperLip', 'lowerLip', 'chin', 'neck', 'cheek', 'jowl'],
  },
]

/**
 * Typical angle, in radians, by which the skin above the eyes faces upwards: 0.16 to 0.4 in human heads (9 to 23 degrees). In face
 * coordinates, the line from eyes to mouth is vertical. If the mouth protrudes, these coordinates therefore tilt the head forwards, and the
 * angle is smaller.
 */
const LEAN = 0.24
// Box of the skin above the eyes, in millimetres.
/** Minimum and maximum height above the eyes. */
const ABOVE = [5, 60] as const
/** Maximum distance from the middle of the face. */
const BESIDE = 45
/** Maximum distance behind the eyes. */
const BEHIND = 30

/**
 * Returns how far the mouth protrudes in comparison with a human face, in millimetres. `LEAN` minus the measured angle is the forward tilt of
 * the head in face coordinates. The result is the height of the eyes above the mouth times the tangent of the tilt.
 */
function muzzleOf({
  landmarks: { eye, mouthCorner },
  surface: { points, normals, areas },
}: MeasuredFace): number {
  let [up, forwards] = [0, 0]
  for (let i = 0; i < areas.length; i++) {
    const [x, y, z] = [points[3 * i], points[3 * i + 1], points[3 * i + 2]]
    const isAbove = y > ABOVE[0] && y < ABOVE[1] && Math.abs(x) < BESIDE && z > eye[2] - BEHIND
    if (!isAbove || normals[3 * i + 2] < 0.2) continue
    up += areas[i] * normals[3 * i + 1]
    forwards += areas[i] * normals[3 * i + 2]
  }
  // A mesh that ends at the brows has no skin above the eyes, so it cannot be measured.
  if (!(forwards > 0)) return 0
  const lean = LEAN - atan2(up, forwards)
  return ((eye[1] - mouthCorner[1]) * sin(lean)) / cos(lean)
}

export function implausibleMeasures(face: MeasuredFace): ImplausibleMeasure[] {
  return MEASURES.flatMap(({ name, measure, range: [low, high], regions }) => {
    const value = measure(face)
    if (value >= low && value <= high) return []
    return { description: `${name.replace('%s', `${Math.round(value)} mm`)}, not ${low} to ${high}`, regions }
  })
}
