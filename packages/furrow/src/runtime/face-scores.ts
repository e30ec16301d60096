import { sentence } from '../core/error.ts'
import type { BindTargets, TargetBinding } from './target-binding.ts'

/** A blendshape by name and how much of it a camera sees, as MediaPipe's face landmarker lists them. */
export interface FaceScore {
  categoryName: string
  /** 0..1. */
  score: number
}

/** MediaPipe's first category: the score of a neutral face. */
const NEUTRAL = '_neutral'

/** Sets the blendshapes of a face by lists of names and scores. */
export class FaceScoresBase {
  readonly #bind: BindTargets
  #names: string[] = []
  #bindings: TargetBinding[] = []

  /** @param bind finds blendshapes on the meshes of the face. */
  constructor(bind: BindTargets) {
    this.#bind = bind
  }

  /**
   * Sets the blendshapes that the list names, and leaves others as they are. Nothing is allocated while the names stay the same.
   * `_neutral` is ignored, names that no mesh has are left out with one warning, and a score that is NaN counts as 0.
   *
   * @throws FurrowError when nothing under the face has morph targets.
   */
  set(scores: readonly FaceScore[]): void {
    if (!this.#hasNamesOf(scores)) this.#rebind(scores)
    for (let i = 0; i < this.#bindings.length; i++) {
      const { influences, target, name } = this.#bindings[i]
      influences[target] = scores[name].score || 0
    }
  }

  #hasNamesOf(scores: readonly FaceScore[]): boolean {
    if (scores.length !== this.#names.length) return false
    for (let i = 0; i < scores.length; i++) if (scores[i].categoryName !== this.#names[i]) return false
    return true
  }

  #rebind(scores: readonly FaceScore[]): void {
    this.#names = scores.map(({ categoryName }) => categoryName)
    const wanted = this.#names.map((name) => (name === NEUTRAL ? '' : name))
    this.#bindings = this.#bind(wanted)
    const bound = new Set(this.#bindings.map(({ name }) => name))
    const missing = wanted.filter((name, i) => name !== '' && !bound.has(i))
    if (missing.length === 0) return
    console.warn(
      sentence({
        who: 'FaceScores',
        what: 'blendshapes that this face does not have',
        value: missing.join(', '),
        remedy: 'the others are set',
      }),
    )
  }
}
