import type { BoneDriver } from '../../../drivers/bone/definition.ts'
import type { Curve } from '../../../drivers/curve.ts'
import { clamp, rounded } from '../../../math/scalar.ts'
import { dot } from '../../../math/vector.ts'
import type { LimbSkin } from './limb-skin.ts'
import type { JointLink } from './region-plan.ts'

/** Number of straight pieces that approximate the square root. */
const PIECES = 4
/** Angle below rest at which the part of the activation that remains at rest is gone, as a fraction of the full angle. */
const STRETCHED = 0.6

/**
 * Returns the activation at a fraction of the full angle. The depth of folds follows the square root of the length that the skin loses, which is
 * proportional to the angle. So one pattern serves all angles.
 */
export function activationAt(
  { rest, full, slack = 0 }: Pick<JointLink, 'rest' | 'full' | 'slack'>,
  fraction: number,
): number {
  const t = clamp((Math.abs(fraction) - slack) / (1 - slack), 0, 1)
  // Skin that the turn stretches becomes smooth evenly.
  if (full < rest) return fraction < 0 ? rest : rest + (full - rest) * t
  return fraction < 0 ? rest * Math.max(0, 1 - t / STRETCHED) : rest + (full - rest) * Math.sqrt(t)
}

/** Creates the driver of a link: a curve over the rotation of a joint about an axis. */
export function jointDriver(limb: LimbSkin, area: string, link: JointLink): BoneDriver {
  const { turn, slack = 0 } = link
  const { joints } = limb.skeleton
  const joint = turn.joints[turn.joints.length - 1]
  const axes = limb.axes[joint]
  const fractions = Array.from({ length: PIECES + 1 }, (_, i) => slack + (1 - slack) * (i / PIECES) ** 2)
  const before = link.rest > 0 && link.full > link.rest ? [-STRETCHED] : []
  const curve: Curve = [...before, ...(link.full < link.rest ? [0, 1] : fractions)].map((fraction) => [
    rounded(fraction * turn.full, 1e4),
    rounded(activationAt(link, fraction), 1e4),
  ])
  return {
    type: 'bone',
    area,
    joints: [joints[turn.from].name, joints[joint].name],
    measure: 'angle',
    axis: [
      rounded(dot(axes[0], turn.axis), 1e5),
      rounded(dot(axes[1], turn.axis), 1e5),
      rounded(dot(axes[2], turn.axis), 1e5),
    ],
    curve,
  }
}
