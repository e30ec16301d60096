import type { Node } from '@babylonjs/core/node.js'
import { FaceScoresBase } from '../runtime/face-scores.ts'
import { bindFaceTargets } from './sources/face-targets.ts'

/**
 * Sets the morph targets of a face from a face tracker's names and scores: `scores.set(result.faceBlendshapes[0].categories)`. Any
 * spelling of a name matches, on every mesh under the root. Wrinkles follow through the file's drivers.
 */
export class FaceScores extends FaceScoresBase {
  /** @param face root of the moving meshes: head, eyes, teeth, lashes. */
  constructor(face: Node) {
    super((names) => bindFaceTargets(face, names, 'FaceScores'))
  }
}
