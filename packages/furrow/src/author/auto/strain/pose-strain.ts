import type { SkinSurface } from '../../skin/surface.ts'
import type { Pose } from '../surface/pose.ts'
import { smooth } from './smooth.ts'
import { compressionTensors } from './tensors.ts'

/** Standard deviation in millimetres by which the strain of a face is smoothed: that of a single triangle says little. */
export const FACE_SIGMA = 3

/**
 * The `compressionTensors` of a pose, smoothed.
 *
 * @param offsets of each target by point, in millimetres.
 * @param sigma standard deviation of the smoothing, in millimetres.
 * @param poses how many poses are measured in all.
 */
export function poseStrain(
  surface: SkinSurface,
  offsets: readonly Float64Array[],
  pose: Pose,
  sigma = FACE_SIGMA,
  poses = 1,
): Float64Array {
  const displacements = new Float64Array(surface.points.length)
  for (const [target, weight] of pose) {
    const offset = offsets[target]
    for (let i = 0; i < displacements.length; i++) displacements[i] += weight * offset[i]
  }
  const tensors = compressionTensors(surface, displacements)
  smooth(surface, tensors, sigma, poses)
  return tensors
}
