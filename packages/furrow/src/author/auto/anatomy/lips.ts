import { power } from '../../../math/elementary.ts'
import { median } from '../../../math/quantile.ts'
import { lerp } from '../../../math/scalar.ts'
import type { FaceRng } from './face-rng.ts'
import { chinGroove, mouthLine } from './mouth-line.ts'
import { strongestBend } from './profile.ts'
import { bezierPath, chartPointOf, type FaceContext, type FaceRegion, type Guide } from './region.ts'

/** Fraction of the height from the mouth line to the groove above the chin that the red of the lower lip covers (Farkas 1994). */
const LOWER_RED = 0.55

/** Distances from the middle, relative to the corner of the mouth, at which the ridge above the upper lip is measured. */
const RIDGE_PLACES = [-0.6, -0.45, -0.3, -0.15, 0.15, 0.3, 0.45, 0.6] as const

/** Properties of a lip's lines. */
interface LipLines {
  /** Numbers of lines at 20 and 80 years. */
  counts: readonly [at20: number, at80: number]
  /** Part of the height of the red of the lip (vermilion) that a line covers, from the border of the red. Real lines cross this border. */
  inside: number
  /** Range of lengths outside the red, relative to the skin between the red and the nose (upper lip) or the groove above the chin (lower lip). */
  lengths: readonly [low: number, high: number]
  /** Distance of the innermost lines from the middle of the face, relative to that of the corner of the mouth. The philtrum has no lines. */
  innermost: number
}

const UPPER: LipLines = {
  counts: [10, 18],
  inside: 0.5,
  lengths: [0.15, 0.95],
  innermost: 0.24,
}
const LOWER: LipLines = {
  counts: [9, 16],
  inside: 0.6,
  lengths: [0.3, 1],
  innermost: 0,
}
/** Distance of the outermost lines from the middle of the face, relative to that of the corner of the mouth. */
const OUTERMOST = 0.8
/** Minimum length of a line outside the red, in millimetres. */
const MIN_LENGTH = 2.5
/** Depths along a line, from its start in the red. */
const DEPTHS = [0.8, 1, 0.9, 0.7, 0.45]
/** Depth and width of the shortest line relative to the longest line. */
const SHORTEST = { depth: 0.5, width: 0.65 } as const
/** Slope of the outermost lines away from the vertical. Lines lean outwards in proportion to their distance from the middle. */
const LEAN = 0.4
/** Maximum random change of the slope, and of a line's place as a multiple of the distance between lines. */
const UNEVEN = { lean: 0.2, place: 0.8 } as const
/** Minimum fraction of length that pursed lips lose. Blendshapes of many heads push the lips forwards without compressing all of their skin. */
const COMPRESSION = 0.1
/** Exponent applied to the position of a line between middle (0) and corner of the mouth (1). Below 1, lines are closer together near the corners. */
const CROWDING = 0.75

/** Returns the regions of the lips, with fine lines that run away from the red (orbicularis oris muscle). */
export function lips(context: FaceContext): FaceRegion[] {
  return [lip(context, 'upperLip', 1), lip(context, 'lowerLip', -1)]
}

/** @param away 1 for lines that run upwards from the upper lip, -1 for lines that run downwards from the lower lip. */
function lip(context: FaceContext, name: 'upperLip' | 'lowerLip', away: 1 | -1): FaceRegion {
  const { landmarks, byAge, densityOf, rngOf } = context
  const rng = rngOf(name)
  const [corner] = chartPointOf(landmarks.mouthCorner)
  const border = away > 0 ? upperBorder(context) : lowerBorder(context)
  const { counts, inside, lengths, innermost } = away > 0 ? UPPER : LOWER
  const lines = Math.round(densityOf(name) * (byAge(...counts) + rng.jitter(1)))
  const draw = (rng: FaceRng, i: number): Guide => {
    const place = (2 * (i + 0.5 + rng.across(UNEVEN.place))) / lines - 1
    // Places beyond the outermost one are mirrored at it.
    const fromMiddle = 1 - Math.abs(1 - Math.abs(place))
    const across = Math.sign(place) * corner * lerp(innermost, OUTERMOST, power(fromMiddle, CROWDING))
    const { up: from, red, space } = border(across)
    // Beside the nose, long lines would reach the nasolabial fold.
    const shortening = 1 - (0.5 * across * across) / (corner * corner)
    // The square makes most lines short and shallow, and few long and deep.
    const size = rng.uniform(0, 1) ** 2
    const begin = inside * red
    const length = begin + Math.max(MIN_LENGTH, space * shortening * lerp(...lengths, size))
    const start = from - away * begin
    const lean = length * ((LEAN * across) / corner + rng.across(UNEVEN.lean))
    const depth = lerp(SHORTEST.depth, 1, size)
    // A line in the middle would lie in the philtrum, so it vanishes on a symmetric face.
    const isMiddle = 2 * i + 1 === lines && innermost > 0
    return {
      path: bezierPath(
        1,
        [across, start],
        [across + 0.2 * lean, start + (away * length) / 3],
        [across + 0.6 * lean, start + (away * 2 * length) / 3],
        [across + lean, start + away * length],
      ),
      width: byAge(1.9, 2.4) * lerp(SHORTEST.width, 1, size),
      depth: isMiddle ? rng.towards(0, depth) : depth,
      depths: DEPTHS,
      taper: [0.15, 0.6],
      shoulder: [0.8, 0.8],
      softness: 0.95,
    }
  }
  const guides = rng.row(lines, draw).filter(({ depth }) => depth > 0)
  return {
    name,
    cause: { mouthPucker: 1, mouthFunnel: 0.3 },
    guides,
    spacing: (2 * corner * (OUTERMOST - innermost)) / lines,
    creasedFraction: byAge(0.15, 0.7),
    maxDepth: byAge(0.2, 0.5),
    atRest: 0.4,
    assumedCompression: COMPRESSION,
    reach: 1.5,
    feather: 4,
  }
}

/** Returns measures of a lip, in millimetres, at a distance from the middle of the face. */
type Border = (across: number) => {
  /** Height of the border of the red. */
  up: number
  /** Height of the red. */
  red: number
  /** Length of the skin beyond the border. */
  space: number
}

/**
 * The red of the upper lip ends at a ridge between the mouth and the nose. The height of the ridge is the median of several places, because single
 * profiles also bend at the philtrum. The red meets the red of the lower lip in the corners.
 */
function upperBorder(context: FaceContext): Border {
  const { landmarks, radiusAt } = context
  const [corner] = chartPointOf(landmarks.mouthCorner)
  // The mean of both sides: the place where the lips touch is found only to half a millimetre.
  const lineAt = (across: number) => (mouthLine(context, across) + mouthLine(context, -across)) / 2
  const highest = median(
    RIDGE_PLACES.map((place) => {
      const across = place * corner
      const line = lineAt(across)
      const [, ridge] = strongestBend(radiusAt, [across, line], [across, landmarks.noseBase], 1)
      return (ridge - line) / redAt(place)
    }),
  )
  return (across) => {
    const red = highest * redAt(across / corner)
    const up = lineAt(across) + red
    return { up, red, space: landmarks.noseBase - up }
  }
}

/** Returns the height of a lip's red relative to the middle, at a distance from the middle relative to the corner. */
function redAt(place: number): number {
  return Math.sqrt(Math.max(0, 1 - place * place))
}

/** The red of the lower lip ends between the mouth and the groove above the chin. It meets the red of the upper lip in the corners. */
function lowerBorder(context: FaceContext): Border {
  const [corner, mouth] = chartPointOf(context.landmarks.mouthCorner)
  const groove = chinGroove(context)
  const height = mouth - lerp(mouthLine(context, 0), groove, LOWER_RED)
  return (across) => {
    const red = height * redAt(across / corner)
    const up = mouth - red
    return { up, red, space: up - groove }
  }
}
