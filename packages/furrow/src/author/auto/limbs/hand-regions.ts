import { noise } from '../../../math/noise.ts'
import { Rng } from '../../../math/rng.ts'
import { splineAt } from '../../../math/spline.ts'
import { dot, length2 } from '../../../math/vector.ts'
import { add, scale, subtract, type Vector, vectorAt } from '../../../math/vector3.ts'
import type { LineStyle } from '../anatomy/region.ts'
import type { Finger } from '../skeleton/bone-names.ts'
import { subtreeOf } from '../skeleton/hierarchy.ts'
import type { HandJoints } from '../skeleton/humanoid.ts'
import { arcGuides, cylinderChart } from './arcs.ts'
import { type FingerBone, fingerBones, flexion, type HandFrame } from './hand-frame.ts'
import {
  type ArcCrease,
  FINGER_CREASES,
  KNUCKLE_LINES,
  PALM_CREASES,
  type PalmCrease,
} from './hand-tables.ts'
import { guideLayer, LimbChart, type LimbGuide } from './limb-chart.ts'
import { type LimbSkin, pointWeights } from './limb-skin.ts'
import type { JointLink, SkinPlan } from './region-plan.ts'
import { DEGREE } from './turn.ts'

/** Activation of flexion creases on a straight finger: they are folds of the skin that never vanish. */
const REST = 0.4
/** Full angles of flexion in degrees: the ranges of motion of healthy adults (American Academy of Orthopaedic Surgeons 1965). */
const RANGES = { base: 90, middle: 100, last: 80, thumbRoot: 45, thumbBase: 55, thumbTip: 80 } as const
/** Angle in degrees at which the lines on the back of a finger are smooth. */
const SMOOTH = 70
/** Compression of the loose skin on the back of a straight finger, which is long enough for a bent one. */
const LOOSE = 0.16
/** Style of lines on the back of a finger, which are nearly as deep at their sides as in the middle. */
const BACK_STYLE: Partial<LineStyle> = {
  depths: [0.55, 0.9, 1, 0.9, 1, 0.95, 0.55],
  taper: [0.187, 0.187],
  shoulder: [0.95, 0.95],
  softness: 0.45,
}
/** Weight of a finger's joints at its skin. */
const ON_FINGER = 0.4

/** Returns the regions of a hand: creases inside the fingers and in the palm, and lines on the back of the finger joints. */
export function handRegions(
  limb: LimbSkin,
  hand: HandJoints,
  frame: HandFrame,
  settings: { seed: number; ageFraction: number },
): SkinPlan[] {
  const rng = new Rng(settings.seed, `hand ${limb.skeleton.joints[hand.wrist].name}`)
  const bones = new Map(
    [...hand.fingers].map(([finger, joints]) => [finger, fingerBones(limb, frame, finger, joints)]),
  )
  const fingers = [...bones].flatMap(([finger, own]) =>
    fingerRegions(limb, frame, finger, own, rng, settings),
  )
  return [...fingers, ...palmRegions(limb, hand, frame, bones, rng, settings)]
}

function fingerRegions(
  limb: LimbSkin,
  { size: { along: size } }: HandFrame,
  finger: Finger,
  bones: readonly FingerBone[],
  rng: Rng,
  { ageFraction }: { ageFraction: number },
): SkinPlan[] {
  const { joints } = limb.skeleton
  const { surface } = limb.prepared
  const count = bones.length
  return bones.flatMap((bone, i): SkinPlan[] => {
    const fromTip = count - 1 - i
    const isThumb = finger === 'thumb'
    const [creases, range] = creasesOf(isThumb, fromTip)
    if (!creases) return []
    const turn = flexion(limb, bone, range)
    const on = pointWeights(limb, subtreeOf(joints, bones[Math.max(0, i - 1)].joint))
    const isOn = (point: number) => on[point] > ON_FINGER
    // Creases at the base lie beyond the joint, where the fingers separate.
    const isBase = !isThumb && fromTip === 2
    const origin = isBase ? add(bone.place, scale(bone.along, 0.52 * bone.length)) : bone.place
    const frameOf = (front: Vector) => ({ origin, axis: bone.along, front })
    const inside = cylinderChart(limb, frameOf(bone.inside), isOn, size)
    const guides = arcGuides(inside, creases, size, rng)
    const shared = { spacing: 5 * size, reach: 3.2 * size, feather: 3.5 * size, looseness: 4 * size }
    const name = joints[bone.joint].name
    const flexed: SkinPlan = {
      ...shared,
      name: `${name} flexion`,
      turn,
      creasedFraction: 0.5,
      assumedCompression: 0.3,
      maxDepth: size * (isThumb ? 0.95 : 0.9) * (0.9 + 0.25 * ageFraction),
      links: [{ turn, rest: REST, full: 1 }],
      rank: 3 - 0.3 * fromTip,
      lay: guideLayer(surface, guides),
    }
    const lines =
      fromTip === 1 && !isThumb ? KNUCKLE_LINES.middle : fromTip === 0 ? KNUCKLE_LINES.last : undefined
    if (!lines) return [flexed]
    const back = cylinderChart(limb, frameOf(scale(bone.inside, -1)), isOn, size)
    const straight: SkinPlan = {
      ...shared,
      name: `${name} back`,
      turn,
      spacing: 2 * size,
      creasedFraction: 0.5,
      assumedCompression: LOOSE,
      maxDepth: size * 0.5 * (0.8 + 0.6 * ageFraction),
      links: [{ turn: { ...turn, full: SMOOTH * DEGREE }, rest: 1, full: 0 }],
      rank: 1.5 - 0.3 * fromTip,
      lay: guideLayer(surface, arcGuides(back, lines, size, rng, BACK_STYLE)),
    }
    return [flexed, straight]
  })
}

function creasesOf(isThumb: boolean, fromTip: number): [readonly ArcCrease[] | undefined, number] {
  if (isThumb) {
    if (fromTip === 0) return [FINGER_CREASES.thumb, RANGES.thumbTip]
    return fromTip === 1 ? [FINGER_CREASES.thumbBase, RANGES.thumbBase] : [undefined, 0]
  }
  if (fromTip === 0) return [FINGER_CREASES.last, RANGES.last]
  return fromTip === 1 ? [FINGER_CREASES.middle, RANGES.middle] : [FINGER_CREASES.base, RANGES.base]
}

/** Skin belongs to the palm if the cosine between its normal and the direction out of the palm exceeds this. */
const FACING = 0.3
/** Minimum depth of a palm's crease that everybody has. Others are left out at random. */
const MAIN = 0.5
/** Probability that a short crease is left out. */
const LEFT_OUT = 0.25

/** Returns the regions of the palm, which several fingers fold. */
function palmRegions(
  limb: LimbSkin,
  hand: HandJoints,
  frame: HandFrame,
  bones: ReadonlyMap<Finger, readonly FingerBone[]>,
  rng: Rng,
  { ageFraction }: { ageFraction: number },
): SkinPlan[] {
  const { joints } = limb.skeleton
  const { surface } = limb.prepared
  const chart = palmChart(limb, hand, frame)
  const size = frame.size.along
  const linksOf = (fingers: readonly Finger[], degrees: number): JointLink[] => {
    const turns = fingers.flatMap((finger) => {
      const base = bones.get(finger)?.[0]
      return base ? [flexion(limb, base, degrees)] : []
    })
    return turns.map((turn) => ({ turn, rest: (REST + 0.05) / turns.length, full: 1 / turns.length }))
  }
  const hasRoot = (bones.get('thumb')?.length ?? 0) > 2
  const parts = [
    { part: 'distal', links: linksOf(['middle', 'ring', 'little'], RANGES.base) },
    { part: 'proximal', links: linksOf(['index', 'middle'], RANGES.base) },
    { part: 'thenar', links: hasRoot ? linksOf(['thumb'], RANGES.thumbRoot) : [] },
  ] as const
  return parts.flatMap(({ part, links }): SkinPlan[] => {
    if (links.length === 0) return []
    const own = PALM_CREASES[part].filter(({ depth }) => depth >= MAIN || rng.next() > LEFT_OUT)
    const guides = own.map((crease) => palmGuide(chart, crease, size, rng))
    return [
      {
        name: `${joints[hand.wrist].name} ${part} crease`,
        turn: links[0].turn,
        spacing: 11 * size,
        creasedFraction: 0.5,
        assumedCompression: 0.3,
        maxDepth: size * 1.35 * (0.9 + 0.2 * ageFraction),
        reach: 5 * size,
        feather: 6 * size,
        looseness: 8 * size,
        links,
        rank: 4,
        lay: guideLayer(surface, guides),
      },
    ]
  })
}

/** Returns the chart of a palm: its projection onto a plane, in millimetres of the reference hand. */
function palmChart(
  limb: LimbSkin,
  { wrist, fingers }: HandJoints,
  { wrist: origin, x, y, z, size }: HandFrame,
): LimbChart {
  const { joints } = limb.skeleton
  const { surface } = limb.prepared
  const onHand = pointWeights(limb, subtreeOf(joints, wrist))
  const outside = joints.map(() => false)
  for (const [finger, own] of fingers) {
    const first = own[finger === 'thumb' ? Math.max(0, own.length - 2) : Math.min(1, own.length - 1)]
    for (const [i, is] of subtreeOf(joints, first).entries()) if (is) outside[i] = true
  }
  const onFinger = pointWeights(limb, outside)
  return new LimbChart(
    surface,
    (point) => {
      const offset = subtract(vectorAt(surface.points, point), origin)
      return [dot(offset, x) / size.across, dot(offset, y) / size.along]
    },
    (normal, point) => onHand[point] > 0.3 && onFinger[point] < 0.5 && dot(normal, z) > FACING,
  )
}

/** Random shift of the points of a palm's crease, in millimetres of the reference hand. */
const PALM_SHIFT = 1.8
/** Height and length of the waves of a palm's crease, in millimetres. */
const PALM_WAVES = { height: 0.7, length: 15 } as const

function palmGuide(
  chart: LimbChart,
  { points, width, depth }: PalmCrease,
  size: number,
  rng: Rng,
): LimbGuide {
  const shifted = points.flatMap(([x, y]) => [x + rng.jitter(PALM_SHIFT), y + rng.jitter(PALM_SHIFT), 0])
  const seed = rng.integer()
  const at = new Float64Array(3)
  const segments = points.length - 1
  const length = points
    .slice(1)
    .reduce((sum, [x, y], i) => sum + length2(x - points[i][0], y - points[i][1]), 0)
  const waves = length / PALM_WAVES.length
  return {
    chart,
    path: (t) => {
      const segment = Math.min(segments - 1, Math.floor(segments * t))
      splineAt(at, shifted, segment, segments * t - segment)
      const wave = PALM_WAVES.height * noise(waves * t, seed)
      return [at[0] + wave, at[1] + wave]
    },
    style: {
      depths: [0.3, 0.75, 1, 0.9, 1, 0.85, 0.95, 0.7, 0.35],
      taper: [0.2125, 0.255],
      shoulder: [0.7, 0.7],
      softness: 0.35,
      width: size * width * (1 + rng.jitter(0.08)),
      depth: depth * (1 - 0.12 * rng.next()),
    },
  }
}
