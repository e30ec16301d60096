import type { SkinSurface } from '../../skin/surface.ts'

/** Position in face coordinates: x to the person's left, y up, z forwards, in millimetres from the midpoint of the eyes. */
export type LandmarkPosition = readonly [x: number, y: number, z: number]

/** Positions of facial features on the person's left. The features on the right have the opposite x. */
export interface Landmarks {
  /** Centre of the closed lids. */
  eye: LandmarkPosition
  /** Corner of the eye beside the nose. */
  innerCorner: LandmarkPosition
  outerCorner: LandmarkPosition
  /** End of the brow near the nose. */
  innerBrow: LandmarkPosition
  outerBrow: LandmarkPosition
  mouthCorner: LandmarkPosition
  /** Tip of the nose. */
  tip: LandmarkPosition
  /** Lower end of the wing of the nose. */
  wing: LandmarkPosition
  /** Height (y) of the hairline. */
  hairline: number
  /** Height (y) of the base of the nose. */
  noseBase: number
  /** Height (y) of the lower end of the chin. */
  chin: number
}

/** Skin belongs to a lid if a blink moves it by at least this fraction of the blink's largest displacement. */
const LID = 0.15
/** Brow ends and mouth corners consist of the points that a target moves by at least this fraction of its largest displacement. */
const FEATURE_END = 0.85
/** Half the width, in millimetres, of the strip in which the end of a brow is searched. */
const STRIP = 5

/** Height in millimetres of the brow above the centre of the eye (Farkas 1994), for faces whose brows no target moves. */
const BROW_HEIGHT = 20

/** Suffixes in ARKit names for the left and the right side of the face. */
const SIDE_SUFFIXES = ['Left', 'Right'] as const

/**
 * Finds the features of a face by the motion of its targets.
 *
 * @param surface surface in face coordinates, in millimetres.
 * @param browsMoveAsOne whether one target raises the complete brow.
 * @param displacements returns the sum, for each point, of the displacements by the given ARKit shapes.
 * @returns undefined if the eye or the corner of the mouth is not found.
 */
export function findLandmarks(
  surface: SkinSurface,
  browsMoveAsOne: boolean,
  displacements: (...shapes: string[]) => Float64Array,
): Landmarks | undefined {
  /** Returns the position of a feature: the mean of the left feature and the mirrored right feature. */
  const feature = (threshold: number, ...shapes: string[]) => featureNear(undefined, threshold, ...shapes)
  /** Returns the position of a feature, searched in a vertical strip at the distance `across` from the middle. */
  const featureNear = (across: number | undefined, threshold: number, ...shapes: string[]) =>
    mirroredMean(
      SIDE_SUFFIXES.map((side, i) => {
        const moved = onSide(surface, displacements(...shapes.map((shape) => shape + side), ...shapes), i)
        return centroidOf(surface, across === undefined ? moved : inStrip(surface, moved, across), threshold)
      }),
    )
  const lid = extentOf(surface, onSide(surface, displacements('eyeBlinkLeft'), 0), LID)
  const eye = feature(0.3, 'eyeBlink')
  // If one shape raises the complete brow, the brow's ends are searched above the corners of the eye.
  const [inner, outer] = browsMoveAsOne ? [lid.low, lid.high] : []
  const mouthCorner = feature(FEATURE_END, 'mouthSmile')
  if (!eye || !mouthCorner) return undefined
  const browAbove = (across: number): LandmarkPosition => [across, eye[1] + BROW_HEIGHT, eye[2]]
  const down = feature(FEATURE_END, 'browDown')
  const innerBrow = featureNear(inner, FEATURE_END, 'browInnerUp') ?? down ?? browAbove(lid.low)
  const outerBrow = featureNear(outer, FEATURE_END, 'browOuterUp') ?? down ?? browAbove(lid.high)
  const tip = foremost(surface, mouthCorner[1] * 0.75, mouthCorner[1] * 0.25)
  const browHeight = (innerBrow[1] + outerBrow[1]) / 2
  // Hairline, brows, base of the nose and chin divide the face into approximate thirds (Farkas 1994).
  const noseBase = tip[1] + 0.22 * (mouthCorner[1] - tip[1]) - 2
  const third = browHeight - noseBase
  return {
    eye,
    innerCorner: [lid.low, eye[1] - 2, eye[2]],
    outerCorner: [lid.high, eye[1] - 1, eye[2]],
    innerBrow,
    outerBrow,
    mouthCorner,
    tip,
    wing: [Math.max(14, lid.low), noseBase + 4, tip[2] - 16],
    hairline: browHeight + third,
    noseBase,
    chin: noseBase - third,
  }
}

/** Keeps the displacements on one side of the face, and sets all others to 0. Side 0 is the person's left, side 1 the right. */
function onSide({ points }: SkinSurface, displacements: Float64Array, side: number): Float64Array {
  return displacements.map((distance, i) => (points[3 * i] > 0 === (side === 0) ? distance : 0))
}

/** Keeps the displacements in two vertical strips, at x = `across` and at x = `-across`, and sets all others to 0. */
function inStrip({ points }: SkinSurface, displacements: Float64Array, across: number): Float64Array {
  return displacements.map((distance, i) =>
    Math.abs(Math.abs(points[3 * i]) - across) < STRIP ? distance : 0,
  )
}

/** Returns the centroid, weighted by area and displacement, of the points that move at least `threshold` times the largest displacement. */
export function centroidOf(
  { points, areas }: SkinSurface,
  displacements: Float64Array,
  threshold: number,
): number[] | undefined {
  const largest = maxOf(displacements)
  if (!(largest > 0)) return undefined
  const sum = [0, 0, 0]
  let total = 0
  for (let i = 0; i < displacements.length; i++) {
    if (displacements[i] < threshold * largest) continue
    const weight = displacements[i] * areas[i]
    for (let k = 0; k < 3; k++) sum[k] += weight * points[3 * i + k]
    total += weight
  }
  return total > 0 ? sum.map((value) => value / total) : undefined
}

function mirroredMean([left, right]: readonly (number[] | undefined)[]): LandmarkPosition | undefined {
  const sides = [left, right && [-right[0], right[1], right[2]]].filter((side) => side !== undefined)
  if (sides.length === 0) return undefined
  const mean = (k: number) => sides.reduce((sum, side) => sum + side[k], 0) / sides.length
  return [mean(0), mean(1), mean(2)]
}

/** Returns the range of x of the points that move at least `threshold` times the largest displacement. */
function extentOf({ points }: SkinSurface, displacements: Float64Array, threshold: number) {
  const largest = maxOf(displacements)
  let [low, high] = [Infinity, -Infinity]
  for (let i = 0; i < displacements.length; i++) {
    if (displacements[i] < threshold * largest) continue
    low = Math.min(low, points[3 * i])
    high = Math.max(high, points[3 * i])
  }
  return { low, high }
}

function maxOf(values: Float64Array): number {
  return values.reduce((a, b) => Math.max(a, b), 0)
}

/** Returns the foremost point near the middle of the face, between two heights. */
function foremost({ points }: SkinSurface, low: number, high: number): LandmarkPosition {
  let best: LandmarkPosition = [0, (low + high) / 2, 0]
  let z = -Infinity
  for (let i = 0; i < points.length; i += 3) {
    const [x, y] = [points[i], points[i + 1]]
    if (Math.abs(x) > 8 || y < low || y > high || points[i + 2] <= z) continue
    z = points[i + 2]
    best = [0, y, z]
  }
  return best
}
