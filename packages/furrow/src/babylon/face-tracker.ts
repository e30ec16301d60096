import type { Node } from '@babylonjs/core/node.js'
import { FaceTrackerBase } from '../runtime/tracker/face-tracker.ts'
import type { FaceTrackerOptions } from '../runtime/tracker/options.ts'
import { bindFaceTargets } from './sources/face-targets.ts'

/**
 * Moves the morph targets of a face by the scores of a face tracker such as MediaPipe:
 * `tracker.set(result.faceBlendshapes[0].categories)`. The scores are calibrated and filtered. Names may have any spelling that `findTargets`
 * knows. Drivers in the file activate wrinkles by the morph targets.
 */
export class FaceTracker extends FaceTrackerBase {
  /**
   * @param face root node of all meshes of the face: head, eyes, teeth, lashes.
   * @throws FurrowError for an unknown or invalid option.
   */
  constructor(face: Node, options: FaceTrackerOptions = {}) {
    super((names) => bindFaceTargets(face, names, 'FaceTracker'), options)
  }
}
