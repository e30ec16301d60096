import type { Object3D } from 'three'
import { FaceScoresBase } from '../runtime/face-scores.ts'
import { bindTargets } from './sources/bind-targets.ts'

/**
 * Sets the blendshapes of a face from a face tracker's names and scores: `scores.set(result.faceBlendshapes[0].categories)`. Any
 * spelling of a name matches, on every mesh under the root. Wrinkles follow through the file's drivers.
 */
export class FaceScores extends FaceScoresBase {
  /** @param face root of the moving meshes: head, eyes, teeth, lashes. */
  constructor(face: Object3D) {
    super((names) => bindTargets(face, names, 'FaceScores'))
  }
}
