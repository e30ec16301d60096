import type { Object3D } from 'three'
import { FaceTrackerBase } from '../runtime/tracker/face-tracker.ts'
import type { FaceTrackerOptions } from '../runtime/tracker/options.ts'
import { bindTargets } from './sources/bind-targets.ts'

/**
 * Moves the blendshapes of a face by the scores of a face tracker: `tracker.set(result.faceBlendshapes[0].categories)`. The scores are
 * calibrated and filtered. Blendshapes are found by name on every mesh under the root, and `jaw_open` also matches `jawOpen`. The file's
 * drivers then activate the wrinkles.
 */
export class FaceTracker extends FaceTrackerBase {
  /**
   * @param face root of the moving meshes: head, eyes, teeth, lashes.
   * @throws FurrowError for an unknown or invalid option.
   */
  constructor(face: Object3D, options: FaceTrackerOptions = {}) {
    super((names) => bindTargets(face, names, 'FaceTracker'), options)
  }
}
