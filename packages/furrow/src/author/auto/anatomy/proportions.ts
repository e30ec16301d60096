import { atan2, cos, sin } from '../../../math/elementary.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import type { AutoRegion } from './region-names.ts'

/** Facial measure outside the human range, which makes landmarks unreliable for some regions. */
export interface UnusualMeasure {
  /** Description, as part of a sentence. */
  description: string
  regions: readonly AutoRegion[]
}

type MeasuredFace = Pick<DetectedFace, 'landmarks' | 'surface'>

interface Measure {
  name: string
  measure: (face: MeasuredFace) => number
  /** Accepted range in millimetres, for eyes 63 mm apart. */
  range: readonly [low: number, high: number]
  regions: readonly AutoRegion[]
}

/**
 * Measures that regions rely on. An adult's eye is about 31 mm wide, and the nose protrudes by about 20 mm (Farkas 1994, Anthropometry of
 * the Head and Face). The wider ranges exclude only stylised heads.
 */
const MEASURES: readonly Measure[] = [
  {
    name: 'the eyes are %s wide',
    measure: ({ landmarks: { innerCorner, outerCorner } }) => outerCorner[0] - innerCorner[0],
    range: [15, 46],
    regions: ['crowsFeet', 'underEye'],
  },
  {
    name: 'the nose protrudes by %s',
    measure: ({ landmarks: { tip, eye } }) => tip[2] - eye[2],
    range: [12, 70],
    regions: ['nose', 'noseRoot', 'nasolabial'],
  },
  {
    name: 'the mouth is %s below the eyes',
    measure: ({ landmarks: { mouthCorner, eye } }) => eye[1] - mouthCorner[1],
    range: [38, 110],
    regions: ['nasolabial', 'mouthCorner', 'upperLip', 'lowerLip', 'chin', 'neck'],
  },
  {
    name: 'the brows are %s above the eyes',
    measure: ({ landmarks: { innerBrow, outerBrow, eye } }) => (innerBrow[1] + outerBrow[1]) / 2 - eye[1],
    range: [3, 40],
    regions: ['foreheadInner', 'foreheadOuter', 'glabella', 'noseRoot'],
  },
  {
    name: 'the mouth protrudes by %s',
    measure: muzzleOf,
    range: [-40, 15],
    regions: ['nose', 'nasolabial', 'mouthCorner', 'upperLip', 'lowerLip', 'chin', 'neck'],
  },
]

/**
 * Upper bound of the angle in radians by which skin above the eyes faces up from the line between eyes and mouth: 9 to 23 degrees on
 * human heads.
 */
const LEAN = 0.24
/** Box of the skin above the eyes, in millimetres. */
const ABOVE = [5, 60] as const
const BESIDE = 45
const BEHIND = 30

/**
 * Returns how far the mouth protrudes beyond a human one, in millimetres: the tilt of the line from eyes to mouth against the skin above
 * the eyes.
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
  // A mask that ends at the brows cannot be measured.
  if (!(forwards > 0)) return 0
  const lean = LEAN - atan2(up, forwards)
  return ((eye[1] - mouthCorner[1]) * sin(lean)) / cos(lean)
}

/** Returns the measures of a face that are outside the human range. */
export function unusualMeasures(face: MeasuredFace): UnusualMeasure[] {
  return MEASURES.flatMap(({ name, measure, range: [low, high], regions }) => {
    const value = measure(face)
    if (value >= low && value <= high) return []
    return { description: `${name.replace('%s', `${Math.round(value)} mm`)}, not ${low} to ${high}`, regions }
  })
}
