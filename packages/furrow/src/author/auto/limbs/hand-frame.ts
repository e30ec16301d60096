import { dot, length } from '../../../math/vector.ts'
import { across, add, crossed, scale, subtract, unit, type Vector, vectorAt } from '../../../math/vector3.ts'
import type { Finger } from '../skeleton/bone-names.ts'
import { subtreeOf } from '../skeleton/hierarchy.ts'
import type { HandJoints } from '../skeleton/humanoid.ts'
import { type LimbSkin, pointWeights } from './limb-skin.ts'
import { DEGREE, type JointTurn } from './turn.ts'

/**
 * Size of the hand for which the tables of creases are, in millimetres. `length` is measured from the wrist to the base of the middle finger.
 * `width` is measured between the bases of the index finger and the little finger.
 */
export const REFERENCE_HAND = { length: 102, width: 64 } as const

/** Position and size of a hand. */
export interface HandFrame {
  wrist: Vector
  /** Unit vectors: x towards the little finger, y towards the fingers, z out of the palm. */
  x: Vector
  y: Vector
  z: Vector
  /** Size relative to `REFERENCE_HAND`, along the hand and across it. */
  size: { along: number; across: number }
}

/** Minimum sine of the angle between two bones of a thumb at which its axis can be read from the bend. */
const BENT = 0.1

export function handFrame(limb: LimbSkin, { wrist, fingers, side }: HandJoints): HandFrame | undefined {
  const { places } = limb
  const base = (finger: Finger) => fingers.get(finger)?.[0]
  const long = [...fingers].filter(([finger]) => finger !== 'thumb').map(([, joints]) => joints)
  const index = base('index') ?? long[0]?.[0]
  const last = base('little') ?? base('ring') ?? long[long.length - 1]?.[0]
  const middle = base('middle') ?? index
  if (index === undefined || last === undefined || middle === undefined || index === last) return undefined
  const origin = places[wrist]
  const y = unit(subtract(places[middle], origin))
  const out = crossed(subtract(places[last], origin), subtract(places[index], origin))
  const z = scale(across(out, y), palmSide(limb, fingers, side, unit(out)))
  // From the index finger to the little one, whichever hand it is.
  const x = across(subtract(places[last], places[index]), y)
  const width = length(subtract(places[last], places[index]))
  const span = length(subtract(places[middle], origin))
  if (!(width > 0 && span > 0)) return undefined
  return {
    wrist: origin,
    x: across(x, z),
    y,
    z,
    size: { along: span / REFERENCE_HAND.length, across: width / REFERENCE_HAND.width },
  }
}

/** Returns 1 if a vector points out of the palm, -1 if it points out of the back. Without a known side, the thumb and the bend of the fingers tell. */
function palmSide(
  { places }: LimbSkin,
  fingers: HandJoints['fingers'],
  side: HandJoints['side'],
  out: Vector,
): 1 | -1 {
  if (side) return side === 'left' ? 1 : -1
  let votes = 0
  for (const [finger, joints] of fingers) {
    const [a, b, c = b] = joints.map((joint) => places[joint])
    if (finger === 'thumb') votes += dot(unit(subtract(c, a)), out)
    else if (joints.length > 2) votes += dot(subtract(unit(subtract(c, b)), unit(subtract(b, a))), out)
  }
  return votes < 0 ? -1 : 1
}

/** Bone of a finger. */
export interface FingerBone {
  joint: number
  place: Vector
  /** Unit vector along the bone. */
  along: Vector
  /** Length of the bone in millimetres; estimated for the last one. */
  length: number
  /** Unit vector to the side on which the skin folds when the finger bends. */
  inside: Vector
  /** Unit axis of flexion. */
  axis: Vector
}

/** Weight of the last joint of a finger at the skin of its tip. */
const ON_TIP = 0.6

/** Returns the bones of a finger. */
export function fingerBones(
  limb: LimbSkin,
  frame: HandFrame,
  finger: Finger,
  joints: readonly number[],
): FingerBone[] {
  const ends = joints.map((joint) => limb.places[joint])
  const last = ends[ends.length - 1]
  const tip = tipOf(limb, joints[joints.length - 1]) ?? add(last, subtract(last, ends[ends.length - 2]))
  const bones = joints.map((joint, i) => {
    const step = subtract(i + 1 < ends.length ? ends[i + 1] : tip, ends[i])
    return { joint, place: ends[i], along: unit(step), length: length(step) }
  })
  const axis = finger === 'thumb' ? thumbAxis(frame, bones) : undefined
  return bones.map((bone) => {
    const inside = axis ? across(crossed(axis, bone.along), bone.along) : across(frame.z, bone.along)
    return { ...bone, inside, axis: crossed(bone.along, inside) }
  })
}

/** Returns the middle of the skin that follows only the last joint of a finger. */
function tipOf(limb: LimbSkin, joint: number): Vector | undefined {
  const { points, areas } = limb.prepared.surface
  const weights = pointWeights(limb, subtreeOf(limb.skeleton.joints, joint))
  let [sum, total]: [Vector, number] = [[0, 0, 0], 0]
  for (let i = 0; i < areas.length; i++) {
    if (weights[i] < ON_TIP) continue
    sum = add(sum, scale(vectorAt(points, i), areas[i]))
    total += areas[i]
  }
  return total > 0 ? scale(sum, 1 / total) : undefined
}

/** Returns the axis about which a thumb bends: across its bones if it is bent at rest, otherwise so that it moves across the palm. */
function thumbAxis(
  { wrist, x, y, z, size }: HandFrame,
  bones: readonly { place: Vector; along: Vector }[],
): Vector {
  const last = bones[bones.length - 1]
  const palm = add(wrist, add(scale(y, 0.6 * REFERENCE_HAND.length * size.along), scale(z, 10 * size.along)))
  const inwards = across(add(scale(x, 0.75), scale(z, 0.65)), last.along)
  const bend = bones
    .slice(1)
    .map((bone, i) => crossed(bones[i].along, bone.along))
    .filter((turn) => length(turn) > BENT)
    .map(unit)
    .reduce(add, [0, 0, 0])
  const axis = length(bend) > BENT ? unit(bend) : crossed(last.along, inwards)
  return dot(crossed(axis, last.along), subtract(palm, last.place)) < 0 ? scale(axis, -1) : axis
}

/** Returns the turn that bends a finger joint. */
export function flexion(
  { skeleton: { joints } }: LimbSkin,
  { joint, axis }: FingerBone,
  degrees: number,
): JointTurn {
  return { joints: [joint], from: joints[joint].parent, axis, full: degrees * DEGREE }
}
