import type { SkinSkeleton } from '../../skin/skeleton.ts'
import { findHandsByShape, findNeckByShape } from './body-shape.ts'
import {
  type BodyPart,
  type BodySide,
  type BoneName,
  boneNameOf,
  FINGERS,
  type Finger,
} from './bone-names.ts'
import { ancestorsOf, commonAncestor, lineTo, movedSkin } from './hierarchy.ts'
import type { Body, HandJoints, HingedLimb, NeckJoints, TrunkJoints } from './humanoid.ts'
import { findLimbsByName, movesBothHalves } from './limb-joints.ts'
import { findLimbsByShape } from './limbs-by-shape.ts'

/** Minimum number of fingers of a hand. */
const MIN_FINGERS = 3
/** Maximum number of joints of a finger. Further joints at the base lie inside the palm. */
const FINGER_JOINTS = 3

/** Recognises hands, a neck, arms, legs and a trunk by the names of the joints, or by the shape of the skeleton if the names are unknown. */
export function findBody(skeleton: SkinSkeleton): Body {
  const names = skeleton.joints.map(({ name, humanBone }) => boneNameOf(humanBone ?? name))
  const isMoving = movedSkin(skeleton)
  const named = handsByName(skeleton, names, isMoving)
  const hands = named.length > 0 ? named : findHandsByShape(skeleton, isMoving)
  // The hands of a person in clothes belong to another mesh.
  const handsOfAnyMesh = findHandsByShape(
    skeleton,
    skeleton.joints.map(() => true),
  )
  const isNamed = names.some((found) => found?.part === 'head' || found?.part === 'neck')
  const neck = isNamed
    ? neckByName(skeleton, names, isMoving)
    : findNeckByShape(skeleton, handsOfAnyMesh, isMoving)
  const limbsByName = findLimbsByName(skeleton, names)
  const wrists = handsOfAnyMesh.map(({ wrist }) => wrist)
  const limbs = limbsByName.length > 0 ? limbsByName : findLimbsByShape(skeleton, wrists)
  return {
    hands,
    neck,
    limbs: limbs.filter((limb) => movesBothHalves(skeleton.joints, limb, isMoving)),
    trunk: trunkBetween(skeleton, limbs, isMoving),
  }
}

/** Recognises a body by all its joints, also those that move no vertex of a mesh, such as the legs of a shirt's wearer. */
export function findWholeBody(joints: SkinSkeleton['joints']): Body {
  return findBody({
    joints,
    influences: 1,
    indices: [...joints.keys()],
    weights: joints.map(() => 1),
  })
}

/** Returns the spine between the legs and the arms. */
function trunkBetween(
  { joints }: SkinSkeleton,
  limbs: readonly HingedLimb[],
  isMoving: readonly boolean[],
): TrunkJoints | undefined {
  const meetingOf = (kind: HingedLimb['kind']) => {
    const hinges = limbs.filter((limb) => limb.kind === kind).map(({ hinge }) => hinge)
    return hinges.length === 2 ? commonAncestor(joints, hinges) : undefined
  }
  const [base, top] = [meetingOf('knee'), meetingOf('elbow')]
  if (base === undefined || top === undefined) return undefined
  const line = lineTo(joints, top)
  const chain = line.slice(line.indexOf(base) + 1)
  // A shirt follows most of the spine, but trousers and a collar do not.
  const moving = chain.filter((joint) => isMoving[joint]).length
  return line.includes(base) && moving > chain.length / 2 ? { base, chain } : undefined
}

function handsByName(
  skeleton: SkinSkeleton,
  names: readonly (BoneName | undefined)[],
  isMoving: readonly boolean[],
): HandJoints[] {
  const { joints } = skeleton
  const depthOf = (joint: number) => ancestorsOf(joints, joint).length
  const named = (part: BodyPart, side: BodySide) =>
    [...joints.keys()].filter((i) => names[i]?.part === part && names[i]?.side === side)
  return (['left', 'right', undefined] as const).flatMap((side): HandJoints[] => {
    const fingers = new Map<Finger, readonly number[]>()
    for (const finger of FINGERS) {
      const chain = named(finger, side)
        .filter((joint) => isMoving[joint])
        .sort((a, b) => depthOf(a) - depthOf(b))
      if (chain.length > 1) fingers.set(finger, chain.slice(-FINGER_JOINTS))
    }
    if (fingers.size < MIN_FINGERS) return []
    const bases = [...fingers.values()].map(([base]) => base)
    const wrist = named('hand', side)[0] ?? commonAncestor(joints, bases)
    if (wrist === undefined) return []
    return [{ side, wrist, fingers }]
  })
}

function neckByName(
  { joints }: SkinSkeleton,
  names: readonly (BoneName | undefined)[],
  isMoving: readonly boolean[],
): NeckJoints | undefined {
  const depthOf = (joint: number) => ancestorsOf(joints, joint).length
  const all = [...joints.keys()].filter((i) => names[i]?.part === 'neck' || names[i]?.part === 'head')
  const deepest = all.sort((a, b) => depthOf(b) - depthOf(a)).find((i) => isMoving[i])
  if (deepest === undefined) return undefined
  const line = lineTo(joints, deepest)
  const chain = line.filter((joint) => all.includes(joint))
  const base = joints[chain[0]].parent
  return base < 0 ? undefined : { base, chain }
}
