import { dot, length } from '../../../math/vector.ts'
import { subtract, unit, type Vector } from '../../../math/vector3.ts'
import type { SkinJoint, SkinSkeleton } from '../../skin/skeleton.ts'
import type { BoneName, Hinge } from './bone-names.ts'
import { ancestorsOf, childrenOf, placeOf, subtreeOf } from './hierarchy.ts'
import type { HingedLimb } from './humanoid.ts'

/** Bones belong to one line if the cosine between them exceeds this. */
const STRAIGHT = 0.85
/** Range of the ratio between the lengths above and below a hinge. */
export const RATIO = [0.4, 2.5] as const
/** Angle cosine between the upper and the lower half of a limb in the bind pose, at least. */
export const EXTENDED = 0.2

/** Recognises arms and legs by the names of the joints at their hinges. */
export function findLimbsByName(
  { joints }: SkinSkeleton,
  names: readonly (BoneName | undefined)[],
): HingedLimb[] {
  return (['elbow', 'knee'] as const).flatMap((kind) =>
    (['left', 'right', undefined] as const).flatMap((side) => {
      // The first joint of a forearm in parts is the elbow.
      const own = [...joints.keys()].filter(
        (i) =>
          names[i]?.part === kind &&
          names[i]?.side === side &&
          !ancestorsOf(joints, i).some((above) => names[above]?.part === kind),
      )
      const limb = own
        .map((hinge) => limbAt(joints, kind, side, hinge, startOf(joints, names, kind, hinge)))
        .find((found) => found !== undefined)
      return limb ? [limb] : []
    }),
  )
}

/** Returns the limb with a hinge; undefined if the bones around the hinge do not look like one. */
function limbAt(
  joints: readonly SkinJoint[],
  kind: Hinge,
  side: HingedLimb['side'],
  hinge: number,
  start: number,
): HingedLimb | undefined {
  if (start < 0) return undefined
  const end = endOf(joints, hinge)
  const upper = between(joints, start, hinge)
  if (!(length(upper) > 0)) return undefined
  if (end === undefined) return { kind, side, start, hinge, end }
  const lower = between(joints, hinge, end)
  const ratio = length(lower) / length(upper)
  if (ratio < RATIO[0] || ratio > RATIO[1]) return undefined
  return dot(unit(upper), unit(lower)) < EXTENDED ? undefined : { kind, side, start, hinge, end }
}

/** Returns the first joint of the upper half of a limb: by its name, or else the first one of the straight line of bones above the hinge. */
function startOf(
  joints: readonly SkinJoint[],
  names: readonly (BoneName | undefined)[],
  kind: Hinge,
  hinge: number,
): number {
  const part = kind === 'elbow' ? 'upperArm' : 'thigh'
  const named = ancestorsOf(joints, hinge).find((joint) => names[joint]?.part === part)
  let start = named ?? joints[hinge].parent
  if (named !== undefined || start < 0) return start
  const direction = unit(between(joints, start, hinge))
  for (let above = joints[start].parent; above >= 0; above = joints[above].parent) {
    const bone = between(joints, above, start)
    if (length(bone) > 0 && dot(unit(bone), direction) < STRAIGHT) break
    start = above
  }
  return start
}

/** Returns the last joint of the straight line of bones below a hinge. */
function endOf(joints: readonly SkinJoint[], hinge: number): number | undefined {
  let end = hinge
  let direction: Vector | undefined
  for (;;) {
    const next = childrenOf(joints, end)
      .map((child) => ({ child, bone: between(joints, end, child) }))
      .filter(({ bone }) => length(bone) > 0 && (!direction || dot(unit(bone), direction) > STRAIGHT))
      // The hand and the foot have more joints below them than joints that only help to deform the limb.
      .map((found) => ({ ...found, size: subtreeOf(joints, found.child).filter(Boolean).length }))
      .sort((a, b) => b.size - a.size || length(b.bone) - length(a.bone))[0]
    if (!next) return end === hinge ? undefined : end
    const above = childrenOf(joints, next.child).length
    direction ??= unit(next.bone)
    end = next.child
    if (above > 1) return end
  }
}

/** Returns whether both halves of a limb move the skin. */
export function movesBothHalves(
  joints: readonly SkinJoint[],
  { start, hinge }: HingedLimb,
  isMoving: readonly boolean[],
): boolean {
  const below = subtreeOf(joints, hinge)
  const above = [start, ...ancestorsOf(joints, hinge).filter((i) => ancestorsOf(joints, i).includes(start))]
  return above.some((i) => isMoving[i]) && below.some((is, i) => is && isMoving[i])
}

function between(joints: readonly SkinJoint[], a: number, b: number): Vector {
  return subtract(placeOf(joints[b]), placeOf(joints[a]))
}
