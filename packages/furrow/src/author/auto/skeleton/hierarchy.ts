import type { SkinJoint, SkinSkeleton } from '../../skin/skeleton.ts'

/** A joint moves the skin if its weight exceeds this at a vertex. */
const MIN_WEIGHT = 0.05

/** Returns the ancestors of a joint, from the root down. */
export function ancestorsOf(joints: readonly SkinJoint[], joint: number): number[] {
  const above: number[] = []
  for (let at = joints[joint].parent; at >= 0 && above.length < joints.length; at = joints[at].parent)
    above.unshift(at)
  return above
}

/** Returns a joint with its ancestors, from the root down. */
export function lineTo(joints: readonly SkinJoint[], joint: number): number[] {
  return [...ancestorsOf(joints, joint), joint]
}

/** Returns the indices of the joints whose parent is the given joint. */
export function childrenOf(joints: readonly SkinJoint[], joint: number): number[] {
  return [...joints.keys()].filter((i) => joints[i].parent === joint)
}

/** Returns, for each joint, whether it is the given joint or below it. */
export function subtreeOf(joints: readonly SkinJoint[], joint: number): boolean[] {
  return joints.map((_, i) => i === joint || ancestorsOf(joints, i).includes(joint))
}

/** Returns the deepest joint that is an ancestor of all given joints. */
export function commonAncestor(joints: readonly SkinJoint[], of: readonly number[]): number | undefined {
  const [first, ...others] = of.map((joint) => ancestorsOf(joints, joint))
  return first.findLast((joint) => others.every((above) => above.includes(joint)))
}

/** Returns, for each joint, whether it moves any vertex of the skin itself. */
export function movedSkin({ joints, indices, weights }: SkinSkeleton): boolean[] {
  const isMoving = joints.map(() => false)
  for (let i = 0; i < weights.length; i++) if (weights[i] > MIN_WEIGHT) isMoving[indices[i]] = true
  return isMoving
}

/** Returns the position of a joint in the bind pose. */
export function placeOf({ bind }: SkinJoint): [x: number, y: number, z: number] {
  return [bind[12], bind[13], bind[14]]
}
