import { dot, length } from '../../../math/vector.ts'
import { subtract, unit, type Vector } from '../../../math/vector3.ts'
import type { SkinSkeleton } from '../../skin/skeleton.ts'
import { FINGERS, type Finger } from './bone-names.ts'
import { childrenOf, commonAncestor, placeOf, subtreeOf } from './hierarchy.ts'
import type { HandJoints, NeckJoints } from './humanoid.ts'

/** Number of fingers of a hand. */
const FINGER_COUNTS = [4, 5]
/** Number of joints of a finger. */
const FINGER_JOINTS = 3
/** Minimum length of the longest finger, as a fraction of the distance from the wrist to its base. Toes are shorter. */
const FINGER_LENGTH = 0.35

/** Recognises hands by the shape of the skeleton: joints that end in four or five chains of two or more joints. */
export function findHandsByShape(skeleton: SkinSkeleton, isMoving: readonly boolean[]): HandJoints[] {
  const { joints } = skeleton
  const found = [...joints.keys()].flatMap((wrist) => {
    const chains = childrenOf(joints, wrist).flatMap((child) => {
      const chain = chainFrom(skeleton, child, isMoving)
      return chain && chain.length > 1 ? [chain.slice(-FINGER_JOINTS)] : []
    })
    if (!FINGER_COUNTS.includes(chains.length)) return []
    const size = Math.max(
      ...chains.map((chain) => lengthOf(skeleton, chain) / reachTo(skeleton, wrist, chain[0])),
    )
    return size < FINGER_LENGTH ? [] : [{ wrist, chains, size }]
  })
  return found
    .sort((a, b) => b.size - a.size)
    .slice(0, 2)
    .map(({ wrist, chains }) => ({
      side: undefined,
      wrist,
      fingers: fingersOf(skeleton, chains),
    }))
}

/** Recognises the neck of a skeleton with two hands: the only branch besides the arms at the joint where the arms meet. */
export function findNeckByShape(
  skeleton: SkinSkeleton,
  hands: readonly HandJoints[],
  isMoving: readonly boolean[],
): NeckJoints | undefined {
  const { joints } = skeleton
  if (hands.length !== 2) return undefined
  const base = commonAncestor(
    joints,
    hands.map(({ wrist }) => wrist),
  )
  if (base === undefined) return undefined
  const others = childrenOf(joints, base).filter((child) => {
    const below = subtreeOf(joints, child)
    return hands.every(({ wrist }) => !below[wrist]) && below.some((is, i) => is && isMoving[i])
  })
  if (others.length !== 1) return undefined
  const chain = [others[0]]
  for (;;) {
    const children = childrenOf(joints, chain[chain.length - 1])
    const moving = children.filter((child) => isMoving[child])
    // The head ends the chain: it has no joints above it, or several, such as jaw and eyes.
    if (moving.length !== 1) return { base, chain }
    chain.push(moving[0])
  }
}

/** Follows a chain of joints from `first` to its end. Returns the joints that move the skin, or undefined if the chain branches. */
function chainFrom(
  { joints }: SkinSkeleton,
  first: number,
  isMoving: readonly boolean[],
): number[] | undefined {
  const chain: number[] = []
  for (let at = first; ; ) {
    if (isMoving[at]) chain.push(at)
    const children = childrenOf(joints, at)
    if (children.length === 0) return chain
    if (children.length > 1) return undefined
    at = children[0]
  }
}

/** Tells fingers apart: the thumb points away from the others, and the index finger is next to it. */
function fingersOf(skeleton: SkinSkeleton, chains: readonly number[][]): Map<Finger, readonly number[]> {
  const directions = chains.map((chain) => unit(between(skeleton, chain[0], chain[chain.length - 1])))
  const alike = directions.map((a) => directions.reduce((sum, b) => sum + dot(a, b), 0))
  const thumb = chains[alike.indexOf(Math.min(...alike))]
  const others = chains
    .filter((chain) => chain !== thumb)
    .sort((a, b) => distance(skeleton, thumb[0], a[0]) - distance(skeleton, thumb[0], b[0]))
  return new Map([thumb, ...others].map((chain, i) => [FINGERS[i], chain]))
}

function lengthOf(skeleton: SkinSkeleton, chain: readonly number[]): number {
  return chain.slice(1).reduce((sum, joint, i) => sum + distance(skeleton, chain[i], joint), 0)
}

function reachTo(skeleton: SkinSkeleton, a: number, b: number): number {
  return distance(skeleton, a, b) || 1
}

function distance(skeleton: SkinSkeleton, a: number, b: number): number {
  return length(between(skeleton, a, b))
}

function between({ joints }: SkinSkeleton, a: number, b: number): Vector {
  return subtract(placeOf(joints[b]), placeOf(joints[a]))
}
