import { atan2 } from '../../../math/elementary.ts'
import { dot } from '../../../math/vector.ts'
import type { LimbSkin } from './limb-skin.ts'
import type { JointTurn } from './turn.ts'

/** Maximum full angle in radians. Rotations near half a turn have no clear direction. */
const MOST = 2.6

/** Widens a turn to the angle that clips and poses of the file show, if it exceeds the range of a person. */
export function widened(limb: LimbSkin, turn: JointTurn): JointTurn {
  const observed = turn.joints.reduce((sum, joint) => sum + observedAngle(limb, joint, turn), 0)
  return observed > turn.full ? { ...turn, full: Math.min(MOST, observed) } : turn
}

/** Returns the largest rotation of a joint about the axis of a turn, in radians; 0 if the joint only turns the other way. */
function observedAngle({ skeleton, axes }: LimbSkin, joint: number, { axis }: JointTurn): number {
  const { rotations = [] } = skeleton.joints[joint]
  const [x, y, z] = axes[joint].map((own) => dot(own, axis))
  let most = 0
  for (let i = 0; i + 3 < rotations.length; i += 4) {
    const sign = rotations[i + 3] < 0 ? -1 : 1
    const along = rotations[i] * x + rotations[i + 1] * y + rotations[i + 2] * z
    most = Math.max(most, 2 * atan2(sign * along, sign * rotations[i + 3]))
  }
  return most
}
