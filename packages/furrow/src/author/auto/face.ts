import { Chart } from './chart.ts'
import { faceShapeFinder } from './stand-ins.ts'
import { joinSurface, pointAreas, pointOffsets, type Skin, type Surface } from './surface.ts'

/** x, y and z: to the person's left, up and forwards, in millimetres from the middle between the eyes. */
export type Place = readonly [x: number, y: number, z: number]

/** Where the features of a face are, on the person's left; the right ones have the other sign of x. */
export interface Landmarks {
  /** Middle of the closed lids, and where they meet. */
  eye: Place
  innerCorner: Place
  outerCorner: Place
  innerBrow: Place
  outerBrow: Place
  mouthCorner: Place
  /** Of the nose: its tip, and the lower end of its side. */
  tip: Place
  wing: Place
  /** Heights alone: where the hair begins, where the nose meets the lip, the chin's lower end. */
  hairline: number
  noseBase: number
  chin: number
}

/** A skin that was recognised as a face. */
export interface Face {
  /** In millimetres, in the frame of the face. */
  surface: Surface
  /** The same, unrolled. */
  chart: Chart
  landmarks: Landmarks
  /** What each target adds to the points, in millimetres, in the order of the skin's targets. */
  offsets: readonly Float64Array[]
  /** Names of the targets. */
  names: readonly string[]
  /** Indices of the targets of that name, in any rig's spelling, or of what stands in for it. */
  find(name: string): number[]
}

/** Millimetres between the middles of an adult's eyes (mean of women's 61.7 and men's 64.0; Dodgson 2004): faces are scaled to it. */
const EYE_DISTANCE = 63
/** Share of the largest way by which a target moves its lid, from which on skin counts as lid. */
const LID = 0.15
/** Of those points that move most, the share of the largest way that a feature's place is taken from. */
const FEATURE = 0.85
/** Half the width, in millimetres, of the strip in which the end of a brow is looked for. */
const NEAR = 5

/** Places of one side are found by targets that move it. */
const SIDES = ['Left', 'Right'] as const

/**
 * Recognises a face by what its targets move: lids blink, brows rise, corners of the mouth smile.
 *
 * @returns undefined where the targets needed for that have other names, or move nothing.
 */
export function findFace(skin: Skin): Face | undefined {
  const joined = joinSurface(skin)
  const names = skin.targets.map(({ name }) => name)
  const find = faceShapeFinder(names)
  const raw = skin.targets.map((target) => pointOffsets(joined, target))
  const ways = (...shapes: string[]) => sumOfWays(raw, shapes.flatMap(find), joined.areas.length)
  const eyes = SIDES.map((side) => centreOf(joined, ways(`eyeBlink${side}`), 0.3))
  const mouth = centreOf(joined, ways('mouthSmileLeft', 'mouthSmileRight', 'mouthStretch', 'mouthFrown'), 0.5)
  const brows = centreOf(joined, ways('browInnerUp', 'browDownLeft', 'browDownRight', 'browOuterUp'), 0.3)
  if (!eyes[0] || !eyes[1] || !mouth || !brows) return undefined
  const turn = frameOf(eyes as [number[], number[]], mouth)
  if (!turn) return undefined
  const points = turn(joined.points, 1)
  const areas = pointAreas(points, joined.corners)
  const surface = { ...joined, points, areas, normals: turn(joined.normals, 0) }
  const offsets = raw.map((offset) => turn(offset, 0, true))
  const browsMoveAsOne = `${find('browInnerUp')}` === `${find('browOuterUpLeft')}`
  const landmarks = findLandmarks(surface, browsMoveAsOne, (...shapes) =>
    sumOfWays(offsets, shapes.flatMap(find), surface.areas.length),
  )
  return landmarks && { surface, chart: new Chart(surface), landmarks, offsets, names, find }
}

/**
 * Turns coordinates into the frame of the face: places so that the middle between the eyes becomes the origin, in millimetres; ways
 * are turned alone, and scaled where they are lengths.
 */
function frameOf([left, right]: [number[], number[]], mouth: number[]) {
  const middle = left.map((value, k) => (value + right[k]!) / 2)
  const across = left.map((value, k) => value - right[k]!)
  const distance = Math.hypot(...across)
  const x = across.map((value) => value / distance)
  const rise = middle.map((value, k) => value - mouth[k]!)
  const along = rise.reduce((sum, value, k) => sum + value * x[k]!, 0)
  const upright = rise.map((value, k) => value - along * x[k]!)
  const height = Math.hypot(...upright)
  if (!(distance > 0 && height > 0)) return undefined
  const y = upright.map((value) => value / height)
  const z = [0, 1, 2].map((k) => x[(k + 1) % 3]! * y[(k + 2) % 3]! - x[(k + 2) % 3]! * y[(k + 1) % 3]!)
  const scale = EYE_DISTANCE / distance
  return (values: Float64Array, isPlace: 0 | 1, isLength = isPlace === 1): Float64Array => {
    const out = new Float64Array(values.length)
    for (let i = 0; i < values.length; i += 3) {
      for (const [row, axis] of [x, y, z].entries()) {
        let sum = 0
        for (let k = 0; k < 3; k++) sum += axis[k]! * (values[i + k]! - isPlace * middle[k]!)
        out[i + row] = isLength ? scale * sum : sum
      }
    }
    return out
  }
}

function findLandmarks(
  surface: Surface,
  browsMoveAsOne: boolean,
  ways: (...names: string[]) => Float64Array,
): Landmarks | undefined {
  /** A feature's place, the mean of both sides' with the right one mirrored. */
  const feature = (share: number, ...names: string[]) => featureNear(undefined, share, ...names)
  /** The same of what lies under a place across the face. */
  const featureNear = (across: number | undefined, share: number, ...names: string[]) =>
    mirroredMean(
      SIDES.map((side, i) => {
        const moved = onSide(surface, ways(...names.map((name) => name + side), ...names), i)
        return centreOf(surface, across === undefined ? moved : onlyNear(surface, moved, across), share)
      }),
    )
  const lid = spanOf(surface, onSide(surface, ways('eyeBlinkLeft'), 0), LID)
  const eye = feature(0.3, 'eyeBlink')
  // Where one shape raises the whole brow, its ends are known by the eye: they lie above its corners.
  const [inner, outer] = browsMoveAsOne ? [lid.least, lid.most] : []
  const innerBrow = featureNear(inner, FEATURE, 'browInnerUp') ?? feature(FEATURE, 'browDown')
  const outerBrow = featureNear(outer, FEATURE, 'browOuterUp') ?? feature(FEATURE, 'browDown')
  const mouthCorner = feature(FEATURE, 'mouthSmile')
  if (!eye || !innerBrow || !outerBrow || !mouthCorner) return undefined
  const tip = foremost(surface, mouthCorner[1] * 0.75, mouthCorner[1] * 0.25)
  const browHeight = (innerBrow[1] + outerBrow[1]) / 2
  // The face is three thirds: hairline, brows, base of the nose, chin; the lips meet a third below the nose (Farkas 1994 finds it near enough).
  const noseBase = tip[1] + 0.22 * (mouthCorner[1] - tip[1]) - 2
  const third = browHeight - noseBase
  return {
    eye,
    innerCorner: [lid.least, eye[1] - 2, eye[2]],
    outerCorner: [lid.most, eye[1] - 1, eye[2]],
    innerBrow,
    outerBrow,
    mouthCorner,
    tip,
    wing: [Math.max(14, lid.least), noseBase + 4, tip[2] - 16],
    hairline: browHeight + third,
    noseBase,
    chin: noseBase - third,
  }
}

/** How far each point goes in all, by these targets. */
function sumOfWays(
  offsets: readonly Float64Array[],
  targets: readonly number[],
  count: number,
): Float64Array {
  const out = new Float64Array(count)
  for (const target of targets) {
    const offset = offsets[target]!
    for (let i = 0; i < count; i++)
      out[i]! += Math.hypot(offset[3 * i]!, offset[3 * i + 1]!, offset[3 * i + 2]!)
  }
  return out
}

/** Nothing of the other side; 0 is the left one. */
function onSide({ points }: Surface, ways: Float64Array, side: number): Float64Array {
  return ways.map((way, i) => (points[3 * i]! > 0 === (side === 0) ? way : 0))
}

/** Nothing but what lies within a few millimetres of a place across the face. */
function onlyNear({ points }: Surface, ways: Float64Array, across: number): Float64Array {
  return ways.map((way, i) => (Math.abs(Math.abs(points[3 * i]!) - across) < NEAR ? way : 0))
}

/** Mean place of the points that go at least `share` of the longest way, by surface and way. */
function centreOf({ points, areas }: Surface, ways: Float64Array, share: number): number[] | undefined {
  const longest = ways.reduce((a, b) => Math.max(a, b), 0)
  if (!(longest > 0)) return undefined
  const sum = [0, 0, 0]
  let total = 0
  for (let i = 0; i < ways.length; i++) {
    if (ways[i]! < share * longest) continue
    const weight = ways[i]! * areas[i]!
    for (let k = 0; k < 3; k++) sum[k]! += weight * points[3 * i + k]!
    total += weight
  }
  return total > 0 ? sum.map((value) => value / total) : undefined
}

function mirroredMean([left, right]: readonly (number[] | undefined)[]): Place | undefined {
  const sides = [left, right && [-right[0]!, right[1]!, right[2]!]].filter((place) => place !== undefined)
  if (sides.length === 0) return undefined
  return [0, 1, 2].map(
    (k) => sides.reduce((sum, place) => sum + place[k]!, 0) / sides.length,
  ) as unknown as Place
}

/** From where to where, across the face, a target moves skin. */
function spanOf({ points }: Surface, ways: Float64Array, share: number) {
  const longest = ways.reduce((a, b) => Math.max(a, b), 0)
  let [least, most] = [Infinity, -Infinity]
  for (let i = 0; i < ways.length; i++) {
    if (ways[i]! < share * longest) continue
    least = Math.min(least, points[3 * i]!)
    most = Math.max(most, points[3 * i]!)
  }
  return { least, most }
}

/** The point that lies farthest forwards between two heights, near the middle. */
function foremost({ points }: Surface, low: number, high: number): Place {
  let best: Place = [0, (low + high) / 2, 0]
  let z = -Infinity
  for (let i = 0; i < points.length; i += 3) {
    const [x, y] = [points[i]!, points[i + 1]!]
    if (Math.abs(x) > 8 || y < low || y > high || points[i + 2]! <= z) continue
    z = points[i + 2]!
    best = [0, y, z]
  }
  return best
}

/** Weights by target, of those that the skin has. */
export function poseOf(
  find: (name: string) => number[],
  weights: Readonly<Record<string, number>>,
): ReadonlyMap<number, number> {
  const pairs = Object.entries(weights).flatMap(([name, weight]) =>
    find(name).map((target) => [target, weight] as const),
  )
  return new Map(pairs)
}
