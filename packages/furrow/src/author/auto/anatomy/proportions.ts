import { atan2, cos, sin } from '../../../math/elementary.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import type { AutoRegion } from './region-names.ts'

/** A measure of a face that is outside of what people have, by which its landmarks fail some regions. */
export interface OddMeasure {
  /** Part of a sentence. */
  what: string
  regions: readonly AutoRegion[]
}

/** The measured parts of a face. */
type MeasuredFace = Pick<DetectedFace, 'landmarks' | 'surface'>

interface Measure {
  name: string
  of: (face: MeasuredFace) => number
  /** In millimetres, of a face whose eyes are 63 mm apart. */
  range: readonly [low: number, high: number]
  regions: readonly AutoRegion[]
}

/**
 * Measures that regions rely on. An adult's eye is about 31 mm wide, and the nose stands out by about 20 mm (Farkas 1994, Anthropometry of the Head and
 * Face); the ranges are much wider, so that they exclude stylised heads alone.
 */
const MEASURES: readonly Measure[] = [
  {
    name: 'the eyes are %s wide',
    of: ({ landmarks: { innerCorner, outerCorner } }) => outerCorner[0] - innerCorner[0],
    range: [15, 46],
    regions: ['crowsFeet', 'underEye'],
  },
  {
    name: 'the nose stands out by %s',
    of: ({ landmarks: { tip, eye } }) => tip[2] - eye[2],
    range: [12, 70],
    regions: ['nose', 'noseRoot', 'nasolabial'],
  },
  {
    name: 'the mouth is %s below the eyes',
    of: ({ landmarks: { mouthCorner, eye } }) => eye[1] - mouthCorner[1],
    range: [38, 110],
    regions: ['nasolabial', 'mouthCorner', 'upperLip', 'lowerLip', 'chin', 'neck'],
  },
  {
    name: 'the brows are %s above the eyes',
    of: ({ landmarks: { innerBrow, outerBrow, eye } }) => (innerBrow[1] + outerBrow[1]) / 2 - eye[1],
    range: [3, 40],
    regions: ['foreheadInner', 'foreheadOuter', 'glabella', 'noseRoot'],
  },
  {
    name: 'the mouth stands out by %s',
    of: muzzleOf,
    range: [-40, 15],
    regions: ['nose', 'nasolabial', 'mouthCorner', 'upperLip', 'lowerLip', 'chin', 'neck'],
  },
]

/** Angle by which skin above the eyes faces up from the line between eyes and mouth, in radians: 9 to 23 degrees on heads of people. */
const LEAN = 0.24
/** Skin above the eyes, in millimetres. */
const ABOVE = [5, 60] as const
const BESIDE = 45
const BEHIND = 30

/** Millimetres by which the mouth lies before people's: the line from eyes to mouth leans on the skin above the eyes. */
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
  // A mask that ends at the brows tells nothing.
  if (!(forwards > 0)) return 0
  const lean = LEAN - atan2(up, forwards)
  return ((eye[1] - mouthCorner[1]) * sin(lean)) / cos(lean)
}

/** The measures of a face in which it is unlike people. */
export function oddMeasures(face: MeasuredFace): OddMeasure[] {
  return MEASURES.flatMap(({ name, of, range: [low, high], regions }) => {
    const value = of(face)
    if (value >= low && value <= high) return []
    return { what: `${name.replace('%s', `${Math.round(value)} mm`)}, not ${low} to ${high}`, regions }
  })
}
