import { dot, length } from '../../../math/vector.ts'
import { subtract, unit, type Vector } from '../../../math/vector3.ts'
import type { SkinSkeleton } from '../../skin/skeleton.ts'
import type { Hinge } from './bone-names.ts'
import { ancestorsOf, childrenOf, commonAncestor, lineTo, placeOf, subtreeOf } from './hierarchy.ts'
import type { HingedLimb } from './humanoid.ts'
import { EXTENDED, RATIO } from './limb-joints.ts'

/** Two branches of a skeleton that are equally long: both arms or both legs. */
interface Pair {
  /** Joint at which the branches begin. */
  joint: number
  first: readonly [number, number]
  /** Distance along the bones from `joint` to the farthest end of a branch. */
  reach: number
}

/** Maximum relative difference between the lengths of both branches of a pair. */
const ALIKE = 0.12
/** Minimum distance between the ends of a pair, as a fraction of the reach. Copies of a chain coincide. */
const APART = 0.03
/** Minimum reach of arms, as a fraction of the reach of legs. Bones of a chest or a collar are shorter. */
const ARM_LENGTH = 0.4
/** Maximum cosine between the direction of legs and the spine. The legs of animals are perpendicular to it. */
const UPRIGHT = -0.5
/** Usual ratio between the lengths of the upper and the lower half of a limb. */
const USUAL_RATIO = 1.05
/** Weights of the parts of a limb that its halves do not cover, and of bends inside the halves. */
const COSTS = { uncovered: 0.5, bent: 1 } as const

/**
 * Recognises arms and legs by the shape of the skeleton. Two branches with hands, or two equally long branches beside a neck, are arms. Two more
 * at the other end of the spine, which point away from it, are legs. A hinge divides a limb into halves of similar length.
 *
 * @param wrists joints of the hands of the skeleton, if it has fingers.
 */
export function findLimbsByShape(skeleton: SkinSkeleton, wrists: readonly number[]): HingedLimb[] {
  const { joints } = skeleton
  const lengths = branchLengths(skeleton)
  const withHands = armsOf(skeleton, wrists, lengths)
  const found = (
    withHands ? [withHands] : joints.flatMap((_, joint) => pairAt(skeleton, joint, lengths) ?? [])
  )
    .flatMap((arms) => {
      const legs = legsOf(skeleton, arms, lengths)
      return legs ? [{ arms, legs, depth: ancestorsOf(joints, arms.joint).length }] : []
    })
    // The arms of a person are nearer to the root than branches of the head.
    .sort((a, b) => a.depth - b.depth)[0]
  if (!found) return []
  const chainTo = (first: number, end: number) => {
    const line = lineTo(joints, end)
    return line.slice(line.indexOf(first))
  }
  const arms = found.arms.first.map((first) => {
    const below = subtreeOf(joints, first)
    const hand = wrists.find((wrist) => below[wrist])
    return limbOf(skeleton, 'elbow', chainTo(first, hand ?? farthest(skeleton, first, lengths)), hand)
  })
  const legs = found.legs.first.map((first) =>
    limbOf(skeleton, 'knee', chainTo(first, farthest(skeleton, first, lengths))),
  )
  return [...arms, ...legs].filter((limb) => limb !== undefined)
}

/** Returns the arms of a skeleton with two hands. */
function armsOf(skeleton: SkinSkeleton, hands: readonly number[], lengths: Float64Array): Pair | undefined {
  const { joints } = skeleton
  const joint = hands.length === 2 ? commonAncestor(joints, hands) : undefined
  if (joint === undefined) return undefined
  const first = hands.map((hand) => {
    const line = lineTo(joints, hand)
    return line[line.indexOf(joint) + 1]
  })
  const reach = Math.max(...first.map((child) => reachBelow(skeleton, child, lengths)))
  return { joint, first: [first[0], first[1]], reach }
}

/** Returns the longest pair of branches that can be the legs of a person with the given arms. */
function legsOf(skeleton: SkinSkeleton, arms: Pair, lengths: Float64Array): Pair | undefined {
  const { joints } = skeleton
  const beyond = subtreeOf(joints, arms.joint)
  const hasNeck = childrenOf(joints, arms.joint).length > arms.first.length
  if (!hasNeck) return undefined
  const spine = lineTo(joints, arms.joint)
  return [...joints.keys()]
    .filter((joint) => !beyond[joint])
    .flatMap((joint) => pairAt(skeleton, joint, lengths, spine) ?? [])
    .filter((legs) => arms.reach > ARM_LENGTH * legs.reach && isUpright(skeleton, arms, legs, lengths))
    .sort((a, b) => b.reach - a.reach)[0]
}

/** Returns whether legs point away from the spine. */
function isUpright(skeleton: SkinSkeleton, arms: Pair, legs: Pair, lengths: Float64Array): boolean {
  const spine = between(skeleton, legs.joint, arms.joint)
  return legs.first.every((first) => {
    const leg = between(skeleton, first, farthest(skeleton, first, lengths))
    return length(leg) > 0 && length(spine) > 0 && dot(unit(leg), unit(spine)) < UPRIGHT
  })
}

/**
 * Returns the longest two equally long branches that begin at a joint.
 *
 * @param others first joints of branches that do not count.
 */
function pairAt(
  skeleton: SkinSkeleton,
  joint: number,
  lengths: Float64Array,
  others: readonly number[] = [],
): Pair | undefined {
  const branches = childrenOf(skeleton.joints, joint)
    .filter((child) => !others.includes(child))
    .map((child) => ({ child, reach: reachBelow(skeleton, child, lengths) }))
    .sort((a, b) => b.reach - a.reach)
  for (const [i, { child: a, reach }] of branches.entries())
    for (const { child: b, reach: other } of branches.slice(i + 1)) {
      if (other < (1 - ALIKE) * reach) break
      const ends = [a, b].map((first) => farthest(skeleton, first, lengths))
      if (length(between(skeleton, ends[0], ends[1])) > APART * reach) return { joint, first: [a, b], reach }
    }
  return undefined
}

/**
 * Returns the limb whose hinge divides a chain of joints best; undefined if the chain does not look like a limb.
 *
 * @param end joint of the hand, if it is known.
 */
function limbOf(
  skeleton: SkinSkeleton,
  kind: Hinge,
  chain: readonly number[],
  end?: number,
): HingedLimb | undefined {
  const along = chain.map((_, i) => pathLength(skeleton, chain.slice(0, i + 1)))
  const total = along[along.length - 1]
  let best: { cost: number; limb: HingedLimb } | undefined
  for (let i = 0; i < chain.length; i++)
    for (let j = i + 1; j < chain.length; j++)
      for (let k = j + 1; k < chain.length; k++) {
        if (end !== undefined && chain[k] !== end) continue
        const [upper, lower] = [between(skeleton, chain[i], chain[j]), between(skeleton, chain[j], chain[k])]
        const [u, l] = [length(upper), length(lower)]
        if (!(u > 0 && l > 0) || l / u < RATIO[0] || l / u > RATIO[1]) continue
        if (dot(unit(upper), unit(lower)) < EXTENDED) continue
        const bent = (along[j] - along[i]) / u + (along[k] - along[j]) / l - 2
        const uncovered = 1 - (u + l) / total
        const uneven = Math.max(u / l / USUAL_RATIO, (USUAL_RATIO * l) / u) - 1
        const cost = uneven ** 2 + COSTS.uncovered * uncovered ** 2 + COSTS.bent * Math.max(0, bent)
        if (best && cost >= best.cost) continue
        best = { cost, limb: { kind, side: undefined, start: chain[i], hinge: chain[j], end: chain[k] } }
      }
  return best?.limb
}

/** Returns, for each joint, the distance along the bones to the farthest joint below it. */
function branchLengths(skeleton: SkinSkeleton): Float64Array {
  const { joints } = skeleton
  const lengths = new Float64Array(joints.length)
  const depths = joints.map((_, joint) => ancestorsOf(joints, joint).length)
  const deepestFirst = [...joints.keys()].sort((a, b) => depths[b] - depths[a])
  for (const joint of deepestFirst) {
    const { parent } = joints[joint]
    if (parent >= 0) lengths[parent] = Math.max(lengths[parent], reachBelow(skeleton, joint, lengths))
  }
  return lengths
}

/** Returns the distance along the bones from the parent of a joint to the farthest joint below. */
function reachBelow(skeleton: SkinSkeleton, joint: number, lengths: Float64Array): number {
  return length(between(skeleton, skeleton.joints[joint].parent, joint)) + lengths[joint]
}

/** Returns the farthest joint below a joint, along the bones. */
function farthest(skeleton: SkinSkeleton, joint: number, lengths: Float64Array): number {
  const reachOf = (child: number) => reachBelow(skeleton, child, lengths)
  const next = childrenOf(skeleton.joints, joint).sort((a, b) => reachOf(b) - reachOf(a))[0]
  return next === undefined ? joint : farthest(skeleton, next, lengths)
}

function pathLength(skeleton: SkinSkeleton, chain: readonly number[]): number {
  return chain.slice(1).reduce((sum, joint, i) => sum + length(between(skeleton, chain[i], joint)), 0)
}

function between({ joints }: SkinSkeleton, a: number, b: number): Vector {
  return subtract(placeOf(joints[b]), placeOf(joints[a]))
}
