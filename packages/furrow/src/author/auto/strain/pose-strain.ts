import type { SkinSurface } from '../../skin/surface.ts'
import type { Pose } from '../surface/pose.ts'
import { compressionTensors } from '../surface/tensors.ts'
import { smooth } from './smooth.ts'

/** Standard deviation, in millimetres, of the smoothing on faces. Without smoothing, the compression varies strongly between triangles. */
export const FACE_SIGMA = 3

/**
 * Computes the `compressionTensors` of a pose, and smooths them over the surface.
 *
 * @param offsets offsets of each target, per point, in millimetres.
 * @param sigma standard deviation of the smoothing, in millimetres.
 * @param poses total number of poses that are measured on this surface. If there are many, the smoothing is less accurate, to limit the time.
 */
export function poseStrain(
  surface: SkinSurface,
  offsets: readonly Float64Array[],
  pose: Pose,
  sigma = FACE_SIGMA,
  poses = 1,
): Float64Array {
  const tensors = compressionTensors(surface, poseDisplacements(surface, offsets, pose))
  smooth(surface, tensors, sigma, poses)
  return tensors
}

/**
 * Returns the displacement of each point in a pose, in millimetres.
 *
 * @param offsets offsets of each target, per point, in millimetres.
 */
export function poseDisplacements(
  { points }: Pick<SkinSurface, 'points'>,
  offsets: readonly Float64Array[],
  pose: Pose,
): Float64Array {
  const displacements = new Float64Array(points.length)
  for (const [target, weight] of pose) {
    const offset = offsets[target]
    for (let i = 0; i < displacements.length; i++) displacements[i] += weight * offset[i]
  }
  return displacements
}
