import type { Node } from '@babylonjs/core/node.js'
import { FaceScoresBase } from '../runtime/face-scores.ts'
import { bindFaceTargets } from './sources/face-targets.ts'

/**
 * Sets the morph targets of a face from lists of names and scores: `scores.set(result.faceBlendshapes[0].categories)`. Names are found
 * in any spelling, on every mesh that has them; wrinkles follow through the drivers of the file.
 */
export class FaceScores extends FaceScoresBase {
  /** @param face the root of the meshes that move: head, eyes, teeth, lashes. */
  constructor(face: Node) {
    super((names) => bindFaceTargets(face, names, 'FaceScores'))
  }
}
