import type { Object3D } from 'three'
import { sentence } from '../core/error.ts'
import { bindTargets, type TargetBinding } from './sources/bind-targets.ts'

/** A blendshape by name and how much of it a camera sees, as MediaPipe's face landmarker lists them. */
export interface FaceScore {
  categoryName: string
  /** 0..1. */
  score: number
}

/** MediaPipe's first category: how much of none of the others it sees. */
const NEUTRAL = '_neutral'

/**
 * Moves a face by lists of names and scores: `scores.set(result.faceBlendshapes[0].categories)`. Names are found in any spelling, on every
 * mesh that has them; the wrinkles follow by the drivers of the file.
 */
export class FaceScores {
  readonly #face: Object3D
  #names: string[] = []
  #bindings: TargetBinding[] = []

  /** @param face any object above the meshes that move: head, eyes, teeth, lashes. */
  constructor(face: Object3D) {
    this.#face = face
  }

  /**
   * Sets the blendshapes that the list names, and leaves others as they are. Nothing is allocated while the names stay.
   * `_neutral` is passed over, names that no mesh has are left out with one warning, and a score that is no number counts as 0.
   *
   * @throws FurrowError when nothing under the face has morph targets.
   */
  set(scores: readonly FaceScore[]): void {
    if (!this.#knows(scores)) this.#bind(scores)
    for (let i = 0; i < this.#bindings.length; i++) {
      const { influences, target, weight } = this.#bindings[i]
      influences[target] = scores[weight].score || 0
    }
  }

  #knows(scores: readonly FaceScore[]): boolean {
    if (scores.length !== this.#names.length) return false
    for (let i = 0; i < scores.length; i++) if (scores[i].categoryName !== this.#names[i]) return false
    return true
  }

  #bind(scores: readonly FaceScore[]): void {
    this.#names = scores.map(({ categoryName }) => categoryName)
    const wanted = this.#names.map((name) => (name === NEUTRAL ? '' : name))
    this.#bindings = bindTargets(this.#face, wanted, 'FaceScores')
    const bound = new Set(this.#bindings.map(({ weight }) => weight))
    const missing = wanted.filter((name, i) => name !== '' && !bound.has(i))
    if (missing.length === 0) return
    console.warn(
      sentence({
        who: 'FaceScores',
        what: 'blendshapes that this face does not have',
        value: missing.join(', '),
        remedy: 'the others move it all the same',
      }),
    )
  }
}
