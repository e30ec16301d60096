import { atan2 } from '../../../math/elementary.ts'
import { smoothstep } from '../../../math/scalar.ts'
import { dot, length } from '../../../math/vector.ts'
import { across, add, crossed, scale, subtract, unit, type Vector, vectorAt } from '../../../math/vector3.ts'
import type { Hinge } from '../skeleton/bone-names.ts'
import { subtreeOf } from '../skeleton/hierarchy.ts'
import type { HingedLimb } from '../skeleton/humanoid.ts'
import { type LimbSkin, pointWeights } from './limb-skin.ts'

/** Limb with the geometry of its hinge, in millimetres. */
export interface Hinged extends HingedLimb {
  /** Unit axis about which the lower half flexes. */
  axis: Vector
  /** Position of the hinge. */
  place: Vector
  /** Unit directions of the upper and the lower half, towards the hand or foot. */
  halves: readonly [upper: Vector, lower: Vector]
  /** Lengths of the upper and the lower half. */
  lengths: readonly [upper: number, lower: number]
}

/**
 * Full angles in degrees. People flex elbows by 150 and knees by 135 degrees (American Academy of Orthopaedic Surgeons 1965). Beyond the
 * angles here, both halves of a limb touch and hide further folds.
 */
export const FLEXION: Readonly<Record<Hinge, number>> = { elbow: 115, knee: 115 }
/** Fraction of the full angle at which the strain is measured. At larger angles, the crook would pass through itself. */
export const STRAINED = 0.7
/** Sine of the angle between both halves in the bind pose from which on this angle tells the axis. */
const BENT = 0.17
/** Distance from the hinge over which the direction of the limb changes, as a fraction of the shorter half. */
const BEND = 0.35

/** Returns the geometry of a limb; undefined if joints coincide. */
export function hingeOf(limb: LimbSkin, joints: HingedLimb): Hinged | undefined {
  const { places } = limb
  const [start, place] = [places[joints.start], places[joints.hinge]]
  const upper = unit(subtract(place, start))
  const above = length(subtract(place, start))
  const end = joints.end === undefined ? add(place, scale(upper, above)) : places[joints.end]
  const lower = unit(subtract(end, place))
  if (!(above > 0) || !(length(lower) > 0)) return undefined
  return {
    ...joints,
    axis: flexionAxis(limb, joints, upper, lower),
    place,
    halves: [upper, lower],
    lengths: [above, length(subtract(end, place))],
  }
}

/**
 * Returns the position of a point on the cylinder around a limb, which bends at the hinge as in the bind pose.
 *
 * @returns angle in radians from the crook, counterclockwise about the direction to the hand or foot; distance from the hinge along the limb;
 *   radius; vector from the axis.
 */
export function aroundHinge(
  { place, axis, halves: [upper, lower], lengths }: Pick<Hinged, 'place' | 'axis' | 'halves' | 'lengths'>,
  point: Vector,
): { angle: number; along: number; radius: number; away: Vector } {
  const offset = subtract(point, place)
  const t = smoothstep(dot(offset, unit(add(upper, lower))) / (BEND * Math.min(...lengths)) + 0.5)
  const direction = unit(add(scale(upper, 1 - t), scale(lower, t)))
  const along = (1 - t) * dot(offset, upper) + t * dot(offset, lower)
  const away = subtract(offset, scale(direction, dot(offset, direction)))
  // The lower half flexes towards the crook.
  const front = across(crossed(axis, direction), direction)
  return {
    angle: atan2(dot(away, crossed(direction, front)), dot(away, front)),
    along,
    radius: length(away),
    away,
  }
}

/** Surface around a hinge, in coordinates of the limb's cylinder. */
export interface HingePlaces {
  /** Share of the limb's own joints at each point, 0..1. */
  on: Float64Array
  /** Position of each point, see `aroundHinge`. */
  places: readonly ReturnType<typeof aroundHinge>[]
  /** Median radius of the limb near the hinge in millimetres. */
  radius: number
}

/** Share of a limb's own joints from which on a point belongs to the limb completely. */
export const OWN = 0.7
/** Distance from the hinge up to which the radius is measured, as a fraction of the shorter half. */
const NEAR = 0.35

/** Returns the positions of a surface around a hinge; undefined if the surface has no points there. */
export function placesAround(limb: LimbSkin, hinged: Hinged): HingePlaces | undefined {
  const { points } = limb.prepared.surface
  const on = pointWeights(limb, subtreeOf(limb.skeleton.joints, hinged.start))
  const places = Array.from(on, (_, point) => aroundHinge(hinged, vectorAt(points, point)))
  const near = NEAR * Math.min(...hinged.lengths)
  const radii = places
    .filter(({ along }, i) => on[i] > OWN && Math.abs(along) < near)
    .map(({ radius }) => radius)
    .sort((a, b) => a - b)
  return radii.length === 0 ? undefined : { on, places, radius: radii[radii.length >> 1] }
}

/** Returns the axis about which a positive rotation flexes the limb. */
function flexionAxis({ left }: LimbSkin, { kind }: HingedLimb, upper: Vector, lower: Vector): Vector {
  const bend = crossed(upper, lower)
  const forward = crossed(left, [0, 1, 0])
  // Elbows flex forwards, and knees backwards.
  const towards = kind === 'elbow' ? forward : scale(forward, -1)
  const usual = crossed(lower, across(towards, lower))
  const isClear = length(bend) > BENT && dot(unit(bend), usual) > 0
  return unit(isClear ? bend : usual)
}
