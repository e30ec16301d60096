import { wrongArgument } from '../core/argument.ts'
import { formatProblem } from '../core/error.ts'
import type { BindTargets, TargetBinding } from './target-binding.ts'

/** Score of one blendshape, as in the results of MediaPipe's face landmarker. */
export interface FaceScore {
  /** Name of the blendshape. */
  categoryName: string
  /** Weight of the blendshape, 0..1. */
  score: number
}

/** Name of MediaPipe's first category. It is not a blendshape: its score tells how neutral the face is. */
const NEUTRAL = '_neutral'

/** Copies blendshape scores from MediaPipe's face landmarker to a face. Base class for `FaceScores` of each engine. */
export class FaceScoresBase {
  readonly #bind: BindTargets
  #names: string[] = []
  #bindings: TargetBinding[] = []

  /** @param bind finds blendshapes on the meshes of the face. */
  constructor(bind: BindTargets) {
    this.#bind = bind
  }

  /**
   * Sets the weights of the listed blendshapes. `_neutral` is ignored. Unknown names are skipped with one warning. NaN counts as 0.
   * Allocates nothing while the names stay the same.
   *
   * @throws FurrowError if no mesh of the face has morph targets, or if `scores` is not an array of names and scores.
   */
  set(scores: readonly FaceScore[]): void {
    if (!Array.isArray(scores)) throw wrongArgument('FaceScores', 'scores', scores, 'an array')
    if (!this.#hasNamesOf(scores)) this.#rebind(scores)
    for (let i = 0; i < this.#bindings.length; i++) {
      const { influences, target, name } = this.#bindings[i]
      influences[target] = Number(scores[name].score) || 0
    }
  }

  #hasNamesOf(scores: readonly FaceScore[]): boolean {
    if (scores.length !== this.#names.length) return false
    for (let i = 0; i < scores.length; i++) if (scores[i]?.categoryName !== this.#names[i]) return false
    return true
  }

  #rebind(scores: readonly FaceScore[]): void {
    const wrong = scores.find((score) => typeof score?.categoryName !== 'string')
    if (wrong !== undefined || scores.includes(null as never)) {
      throw wrongArgument('FaceScores', 'score', wrong, 'an object with categoryName and score')
    }
    this.#names = scores.map(({ categoryName }) => categoryName)
    const wanted = this.#names.map((name) => (name === NEUTRAL ? '' : name))
    this.#bindings = this.#bind(wanted)
    const bound = new Set(this.#bindings.map(({ name }) => name))
    const missing = wanted.filter((name, i) => name !== '' && !bound.has(i))
    if (missing.length === 0) return
    console.warn(
      formatProblem({
        who: 'FaceScores',
        problem: 'the face lacks blendshapes of the scores',
        value: missing.join(', '),
        remedy: 'the other blendshapes are set',
      }),
    )
  }
}
