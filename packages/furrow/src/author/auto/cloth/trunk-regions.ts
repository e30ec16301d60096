import { atan2 } from '../../../math/elementary.ts'
import { Rng } from '../../../math/rng.ts'
import { fadeOut, smoothstep } from '../../../math/scalar.ts'
import { dot, length } from '../../../math/vector.ts'
import { across, add, crossed, scale, subtract, unit, type Vector, vectorAt } from '../../../math/vector3.ts'
import { SIDES } from '../anatomy/region.ts'
import type { LimbFrame } from '../limbs/limb-chart.ts'
import { type LimbSkin, pointWeights } from '../limbs/limb-skin.ts'
import type { RegionPlan } from '../limbs/region-plan.ts'
import { DEGREE } from '../limbs/turn.ts'
import { ancestorsOf, subtreeOf } from '../skeleton/hierarchy.ts'
import type { TrunkJoints } from '../skeleton/humanoid.ts'
import { TENSOR_SIZE } from '../surface/tensors.ts'
import { CLOTHS, type ClothKind } from './cloth-kinds.ts'
import { foldPlan } from './lay-folds.ts'
import { hemMask } from './masks.ts'

/** How the cloth of a trunk folds when the trunk moves in one direction. */
interface TrunkFold {
  name: string
  /** Axis of the turn: direction in the frame of the trunk to the left, up and to the front. */
  axis: readonly [left: number, up: number, front: number]
  /** Full angle in degrees (American Academy of Orthopaedic Surgeons 1965), limited to what skeletons show without collapsing. */
  degrees: number
  /** Angle from the front towards the person's left around which the folds lie, in degrees. */
  middle: number
  /** Angles from the middle, in degrees, up to which the cloth folds completely, and at which the folds end. */
  span: readonly [whole: number, end: number]
  /** Heights above the legs, as fractions of the trunk, between which the cloth folds completely. */
  along: readonly [low: number, high: number]
  /** Fraction of the compression that acts along the trunk. Twisted cloth folds diagonally. */
  directed: number
}

const FOLDS: readonly TrunkFold[] = [
  {
    name: 'forward',
    axis: [1, 0, 0],
    degrees: 60,
    middle: 0,
    span: [46, 98],
    along: [0.12, 0.54],
    directed: 0.55,
  },
  ...SIDES.map(
    ([side, name]): TrunkFold => ({
      name: `tilt to the ${name.toLowerCase()}`,
      axis: [0, 0, -side],
      degrees: 35,
      middle: 90 * side,
      span: [52, 98],
      along: [0.12, 0.5],
      directed: 0.55,
    }),
  ),
  ...SIDES.map(
    ([side, name]): TrunkFold => ({
      name: `turn to the ${name.toLowerCase()}`,
      axis: [0, side, 0],
      degrees: 45,
      middle: 0,
      span: [150, 178],
      along: [0.1, 0.5],
      directed: 0,
    }),
  ),
]

/**
 * Radius of a tube in millimetres, of a sleeve, whose folds have the wavelength of the cloth. Shells of equal thickness buckle with a wavelength
 * proportional to the square root of the radius (Timoshenko and Gere 1961, Theory of Elastic Stability, 11.1).
 */
const SLEEVE = 50
/** Minimum length of a fold in wavelengths. Short ones on the flat belly would look like dents. */
const SHORTEST = 1.6
/** Number of samples of the cloth per wavelength. A trunk is so large that more would take seconds. */
const SAMPLES = 7
/** Standard deviation of the random turn of the compression, as a slope. */
const LEAN = 0.45
/** Compression at which the cloth buckles. Around a trunk, cloth has less slack than around an elbow. */
const CRITICAL = 0.03
/** Standard deviation of the logarithm of a fold's share of the compression. A few folds around a trunk are much deeper than the others. */
const UNEVENNESS = 1.7
/** Heights over which the folds end below and above, as fractions of the trunk. */
const FADE = 0.35
/** Random change of the weight of the compression where it fades. Folds that ended at one height would show a seam. */
const RAGGED = 0.8
/** Share of the trunk's own joints at which folds begin, and at which they are complete. Shoulders and hips have none. */
const OWN = [0.45, 0.8] as const
/** Length over which the spine bends the cloth, as a fraction of the trunk. */
const BEND = 1.2
/** Smoothing of the compression in radii, as `RegionPlan.looseness`. */
const LOOSENESS = 0.3
/** Fraction of the full angle that the slack of the cloth takes up. */
const SLACK = 0.15

/** Returns the regions of cloth around the trunk, one for each direction in which the spine moves. */
export function trunkRegions(
  limb: LimbSkin,
  { base, chain }: TrunkJoints,
  { seed, strength, cloth }: { seed: number; strength: number; cloth: ClothKind },
): RegionPlan[] {
  const { skeleton, places } = limb
  const { surface } = limb.prepared
  const top = chain[chain.length - 1]
  const spine = subtract(places[top], places[base])
  const tall = length(spine)
  if (!(tall > 0)) return []
  const up = unit(spine)
  const left = across(limb.left, up)
  const front = crossed(left, up)
  const own = pointWeights(limb, trunkJoints(limb, { base, chain }))
  const section = sectionOf(limb, own, { origin: places[base], axis: up, front })
  if (!section) return []
  const { radius, around } = section
  const hem = hemMask(surface)
  const wavelength = CLOTHS[cloth].wavelength * Math.sqrt(radius / SLEEVE)
  const joints = chain.slice(-TENSOR_SIZE)
  // Cloth twists about the middle of the trunk, although the spine is nearer to the back.
  const centres = joints.map(() => section.middle)
  // Skin weights differ between front, sides and back. Cloth is taut around the trunk, so each height turns as a whole, whichever joint bends.
  const moved = (point: number) => smoothstep((around[point].along / tall - 0.5) / BEND + 0.5)
  return FOLDS.map((fold): RegionPlan => {
    const [x, y, z] = fold.axis
    const axis = unit(add(add(scale(left, x), scale(up, y)), scale(front, z)))
    const turn = { joints, from: base, axis, full: fold.degrees * DEGREE, ...(y !== 0 && { centres }) }
    const middle = fold.middle * DEGREE
    const tube = {
      // The chart of each fold begins opposite of its middle, so that few folds cross the chart's border.
      place: (point: number) => [wrapped(around[point].angle - middle), around[point].along] as const,
      radius,
      weight: (point: number) => {
        const { along } = around[point]
        const angle = wrapped(around[point].angle - middle)
        const [low, high] = fold.along
        return (
          smoothstep((own[point] - OWN[0]) / (OWN[1] - OWN[0])) *
          fadeOut(Math.abs(angle) / DEGREE, fold.span) *
          smoothstep((along / tall - low) / FADE + 1) *
          smoothstep((high - along / tall) / FADE + 1) *
          hem(point)
        )
      },
      shown: () => 1,
      wavelength,
      samples: SAMPLES,
      shortest: SHORTEST,
      fan: () => 0,
      directed: fold.directed,
      lean: LEAN,
      critical: CRITICAL,
      unevenness: UNEVENNESS,
      ragged: RAGGED,
      seed: new Rng(seed, `trunk ${fold.name}`).integer(),
    }
    return {
      name: `${skeleton.joints[top].name} ${fold.name}`,
      turn,
      ...foldPlan(limb, tube, strength),
      looseness: LOOSENESS * radius,
      moved,
      links: [{ turn, rest: 0, full: 1, slack: SLACK }],
      rank: 5,
    }
  })
}

/** Returns, for each joint, whether it belongs to the trunk and not to a branch of it, such as a leg, an arm or the neck. */
function trunkJoints({ skeleton: { joints } }: LimbSkin, { base, chain }: TrunkJoints): boolean[] {
  const spine = [base, ...chain]
  const below = subtreeOf(joints, base)
  return joints.map(
    (_, joint) => spine.includes(joint) || (!below[joint] && ancestorsOf(joints, base).includes(joint)),
  )
}

/** Cross-section of a trunk, which is wider than deep. */
interface Section {
  /** Mean radius in millimetres. */
  radius: number
  /** Position of the axis. */
  middle: Vector
  /** Angle of each point from the front towards the person's left in radians, and height above the frame's origin. */
  around: readonly { angle: number; along: number }[]
}

/**
 * Measures the cross-section of the cloth. Its middle is the axis of the cylinder, because a spine is nearer to the back. Angles are
 * those of a circle that is stretched half as much as the section. So lengths around the trunk are the same at the front and at the sides.
 */
function sectionOf(
  { prepared: { surface } }: LimbSkin,
  own: Float64Array,
  { origin, axis, front }: LimbFrame,
): Section | undefined {
  const left = crossed(axis, front)
  const places = Array.from(own, (_, point) => {
    const offset = subtract(vectorAt(surface.points, point), origin)
    return { x: dot(offset, left), y: dot(offset, front), along: dot(offset, axis) }
  })
  const inside = [...own.keys()].filter((point) => own[point] > OWN[1])
  if (inside.length === 0) return undefined
  const [x, y] = (['x', 'y'] as const).map((k) => {
    const values = inside.map((point) => places[point][k]).sort((a, b) => a - b)
    const at = (share: number) => values[Math.round(share * (values.length - 1))]
    return { middle: (at(0.02) + at(0.98)) / 2, half: (at(0.98) - at(0.02)) / 2 }
  })
  if (!(x.half > 0 && y.half > 0)) return undefined
  const [wide, deep] = [Math.sqrt(x.half), Math.sqrt(y.half)]
  return {
    radius: wide * deep,
    middle: add(origin, add(scale(left, x.middle), scale(front, y.middle))),
    around: places.map((place) => ({
      angle: atan2((place.x - x.middle) / wide, (place.y - y.middle) / deep),
      along: place.along,
    })),
  }
}

/** Returns an angle between -pi and pi. */
function wrapped(angle: number): number {
  return angle < -Math.PI ? angle + 2 * Math.PI : angle > Math.PI ? angle - 2 * Math.PI : angle
}
