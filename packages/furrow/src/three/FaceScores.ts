import type { Object3D } from 'three'
import { FaceScoresBase } from '../runtime/face-scores.ts'
import { bindTargets } from './sources/bind-targets.ts'

/**
 * Sets the blendshapes of a face from lists of names and scores: `scores.set(result.faceBlendshapes[0].categories)`. Names are found in
 * any spelling, on every mesh that has them; wrinkles follow through the drivers of the file.
 */
export class FaceScores extends FaceScoresBase {
  /** @param face the root of the meshes that move: head, eyes, teeth, lashes. */
  constructor(face: Object3D) {
    super((names) => bindTargets(face, names, 'FaceScores'))
  }
}
