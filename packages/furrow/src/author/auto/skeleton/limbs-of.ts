import type { Skin } from '../../skin/surface.ts'
import { findBody } from './body.ts'
import { findBends } from './chains.ts'

/** Part of a humanoid with the joints that fold its surface. */
export interface LimbJoints {
  /** Noun for messages: for example `left hand`, `neck`, `left elbow`, `waist`, and `chain` for other skeletons. */
  limb: string
  /** Names of joints. */
  joints: string[]
}

/** Returns the parts of a humanoid that joints of a skin move. */
export function limbsOf({ skeleton }: Pick<Skin, 'skeleton'>): LimbJoints[] {
  if (!skeleton) return []
  const { hands, neck, limbs, trunk } = findBody(skeleton)
  const part = (limb: string, side: string | undefined, indices: readonly number[]) => ({
    limb: side ? `${side} ${limb}` : limb,
    joints: indices.map((i) => skeleton.joints[i].name),
  })
  const found = [
    ...hands.map(({ side, wrist, fingers }) => part('hand', side, [wrist, ...[...fingers.values()].flat()])),
    ...(neck ? [part('neck', undefined, neck.chain)] : []),
    ...limbs.map(({ kind, side, hinge }) => part(kind, side, [hinge])),
    ...(trunk ? [part('waist', undefined, trunk.chain)] : []),
  ]
  const bends = found.length > 0 ? [] : findBends(skeleton).map(({ joint }) => joint)
  return bends.length > 0 ? [part('chain', undefined, bends)] : found
}
