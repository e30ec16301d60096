import type { Landmarks } from '../surface/landmarks.ts'
import type { AutoRegion } from './region-names.ts'

/** A measure of a face that is outside of what people have, by which its landmarks fail some regions. */
export interface OddMeasure {
  /** Part of a sentence. */
  what: string
  regions: readonly AutoRegion[]
}

interface Measure {
  name: string
  of: (landmarks: Landmarks) => number
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
    of: ({ innerCorner, outerCorner }) => outerCorner[0] - innerCorner[0],
    range: [15, 46],
    regions: ['crowsFeet', 'underEye'],
  },
  {
    name: 'the nose stands out by %s',
    of: ({ tip, eye }) => tip[2] - eye[2],
    range: [12, 70],
    regions: ['nose', 'noseRoot', 'nasolabial'],
  },
  {
    name: 'the mouth is %s below the eyes',
    of: ({ mouthCorner, eye }) => eye[1] - mouthCorner[1],
    range: [38, 110],
    regions: ['nasolabial', 'mouthCorner', 'upperLip', 'lowerLip', 'chin', 'neck'],
  },
  {
    name: 'the brows are %s above the eyes',
    of: ({ innerBrow, outerBrow, eye }) => (innerBrow[1] + outerBrow[1]) / 2 - eye[1],
    range: [3, 40],
    regions: ['foreheadInner', 'foreheadOuter', 'glabella', 'noseRoot'],
  },
]

/** The measures of a face in which it is unlike people. */
export function oddMeasures(landmarks: Landmarks): OddMeasure[] {
  return MEASURES.flatMap(({ name, of, range: [low, high], regions }) => {
    const value = of(landmarks)
    if (value >= low && value <= high) return []
    return { what: `${name.replace('%s', `${Math.round(value)} mm`)}, not ${low} to ${high}`, regions }
  })
}
