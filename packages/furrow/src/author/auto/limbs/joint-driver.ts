import type { BoneDriver } from '../../../drivers/bone/definition.ts'
import type { Curve } from '../../../drivers/curve.ts'
import { rounded } from '../../../math/scalar.ts'
import { dot } from '../../../math/vector.ts'
import type { LimbSkin } from './limb-skin.ts'
import type { JointLink } from './region-plan.ts'

/** Number of straight pieces that approximate the square root. */
const PIECES = 8
/** Angle below rest at which the part of the activation that remains at rest is gone, as a fraction of the full angle. */
const STRETCHED = 0.6

/**
 * Returns the activation at a fraction of the full angle. The depth of folds follows the square root of the length that the skin loses, which is
 * proportional to the angle. So one pattern serves all angles.
 */
export function activationAt({ rest, full }: Pick<JointLink, 'rest' | 'full'>, fraction: number): number {
  const t = Math.min(1, Math.abs(fraction))
  // Skin that the turn stretches becomes smooth evenly.
  if (full < rest) return fraction < 0 ? rest : rest + (full - rest) * t
  return fraction < 0 ? rest * Math.max(0, 1 - t / STRETCHED) : rest + (full - rest) * Math.sqrt(t)
}

/** Creates the driver of a link: a curve over the rotation of a joint about an axis. */
export function jointDriver(limb: LimbSkin, area: string, link: JointLink): BoneDriver {
  const { turn } = link
  const { joints } = limb.skeleton
  const joint = turn.joints[turn.joints.length - 1]
  const axes = limb.axes[joint]
  const fractions = Array.from({ length: PIECES + 1 }, (_, i) => (i / PIECES) ** 2)
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
