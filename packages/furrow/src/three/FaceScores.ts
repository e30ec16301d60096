import type { Object3D } from 'three'
import { FaceScoresBase } from '../runtime/face-scores.ts'
import { bindTargets } from './sources/bind-targets.ts'

/**
 * Sets the blendshapes of a face by lists of names and scores: `scores.set(result.faceBlendshapes[0].categories)`. Names are found in
 * any spelling, on every mesh that has them; the wrinkles follow by the drivers of the file.
 */
export class FaceScores extends FaceScoresBase {
  /** @param face any object above the meshes that move: head, eyes, teeth, lashes. */
  constructor(face: Object3D) {
    super((names) => bindTargets(face, names, 'FaceScores'))
  }
}
