import type { Node } from '@babylonjs/core/node.js'
import { FaceScoresBase } from '../runtime/face-scores.ts'
import { bindFaceTargets } from './sources/face-targets.ts'

/**
 * Sets the morph targets of a face from the names and scores of a face tracker such as MediaPipe:
 * `scores.set(result.faceBlendshapes[0].categories)`. Names may have any spelling that `findTargets` knows. Drivers in the file activate
 * wrinkles by the morph targets.
 */
export class FaceScores extends FaceScoresBase {
  /** @param face root node of all meshes of the face: head, eyes, teeth, lashes. */
  constructor(face: Node) {
    super((names) => bindFaceTargets(face, names, 'FaceScores'))
  }
}
