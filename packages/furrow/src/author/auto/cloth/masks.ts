import { cos, sin } from '../../../math/elementary.ts'
import { PointGrid } from '../../../math/point-grid.ts'
import { smoothstep } from '../../../math/scalar.ts'
import { dot } from '../../../math/vector.ts'
import { add, crossed, scale, subtract, vectorAt } from '../../../math/vector3.ts'
import { crossOf, type SkinSurface } from '../../skin/surface.ts'
import { type LimbSkin, pointWeights } from '../limbs/limb-skin.ts'
import type { JointTurn } from '../limbs/turn.ts'
import { subtreeOf } from '../skeleton/hierarchy.ts'

/** Distances from an open edge, in millimetres, at which folds begin and at which they are complete. Hems are stiff. */
const HEM = [8, 34] as const

/** Returns, for each point, a weight that is 0 at open edges of the cloth (hems, cuffs and waistbands) and 1 away from them. */
export function hemMask(surface: SkinSurface): (point: number) => number {
  const edges = new PointGrid(HEM[1])
  const { adjacent, corners, points } = surface
  for (let i = 0; i < adjacent.length; i++)
    if (adjacent[i] < 0) edges.add(points.subarray(3 * corners[i], 3 * corners[i] + 3))
  return (point) => {
    const distance = edges.distance(points.subarray(3 * point, 3 * point + 3))
    return smoothstep((distance - HEM[0]) / (HEM[1] - HEM[0]))
  }
}

/** Ratios of the area of bent to unbent triangles at which folds begin, and at which they are complete. */
const CRUSHED = [0.3, 0.65] as const

/**
 * Returns, for each point, a weight that is 0 where skinning crushes the triangles of a bent limb. Folds there would stick out of the cloth,
 * because linear blending lets the crook pass through itself.
 *
 * @param fraction fraction of the full angle of the turn.
 */
export function crushMask(limb: LimbSkin, turn: JointTurn, fraction: number): Float64Array {
  const { surface } = limb.prepared
  const { corners, points, areas } = surface
  const [joint] = turn.joints
  const weights = pointWeights(limb, subtreeOf(limb.skeleton.joints, joint))
  const centre = limb.places[joint]
  const [c, s] = [cos(fraction * turn.full), sin(fraction * turn.full)]
  const moved = Float64Array.from(points)
  for (let i = 0; i < areas.length; i++) {
    if (!(weights[i] > 0)) continue
    const offset = subtract(vectorAt(points, i), centre)
    const along = scale(turn.axis, dot(offset, turn.axis))
    const away = subtract(offset, along)
    const turned = add(add(along, scale(away, c)), scale(crossed(turn.axis, away), s))
    for (let k = 0; k < 3; k++) moved[3 * i + k] += weights[i] * (turned[k] - offset[k])
  }
  const [normal, sums] = [new Float64Array(3), new Float64Array(areas.length)]
  for (let t = 0; t < corners.length; t += 3) {
    const after = crossOf(moved, corners[t], corners[t + 1], corners[t + 2], normal)
    for (let k = 0; k < 3; k++) sums[corners[t + k]] += after / 6
  }
  return sums.map((sum, i) => smoothstep((sum / areas[i] - CRUSHED[0]) / (CRUSHED[1] - CRUSHED[0])))
}
