import type { SkinSkeleton } from '../../skin/skeleton.ts'
import { childrenOf, movedSkin } from './hierarchy.ts'

/** Joint at which a chain of joints bends, with its neighbours. */
export interface ChainBend {
  above: number
  joint: number
  below: number
}

/** Returns the joints inside chains without branches, such as tails, tentacles and hoses. All joints of a chain move the skin, except its end. */
export function findBends(skeleton: SkinSkeleton): ChainBend[] {
  const { joints } = skeleton
  const isMoving = movedSkin(skeleton)
  return joints.flatMap(({ parent }, joint): ChainBend[] => {
    const children = childrenOf(joints, joint)
    const isInside = parent >= 0 && isMoving[parent] && isMoving[joint] && children.length === 1
    return isInside && childrenOf(joints, parent).length === 1
      ? [{ above: parent, joint, below: children[0] }]
      : []
  })
}
