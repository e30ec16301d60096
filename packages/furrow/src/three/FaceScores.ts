import type { Object3D } from 'three'
import { FaceScoresBase } from '../runtime/face-scores.ts'
import { bindTargets } from './sources/bind-targets.ts'

/**
 * Sets the blendshape weights of a face to the scores of a face tracker: `scores.set(result.faceBlendshapes[0].categories)`. Blendshapes are
 * found by name on every mesh under the root, and `jaw_open` also matches `jawOpen`. The file's drivers then activate the wrinkles.
 */
export class FaceScores extends FaceScoresBase {
  /** @param face root of the moving meshes: head, eyes, teeth, lashes. */
  constructor(face: Object3D) {
    super((names) => bindTargets(face, names, 'FaceScores'))
  }
}
