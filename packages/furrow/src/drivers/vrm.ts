/** As much of three-vrm's `VRMExpression` as is read. */
export interface VrmExpression {
  expressionName: string
  /** Its weight, 0 or 1 where it is binary. */
  outputWeight: number
  isBinary: boolean
  /** How much it takes from all expressions of a kind, 0..1. */
  overrideBlinkAmount: number
  overrideLookAtAmount: number
  overrideMouthAmount: number
}

/** As much of three-vrm's `VRMExpressionManager` as is read. */
export interface VrmExpressions {
  expressions: readonly VrmExpression[]
  blinkExpressionNames: readonly string[]
  lookAtExpressionNames: readonly string[]
  mouthExpressionNames: readonly string[]
}

/** Which of the three overrides an expression is subject to. */
type Kind = 'blink' | 'lookAt' | 'mouth' | null

/**
 * The weights of a VRM's expressions as they are shown: after their overrides (VRM 1.0, `VRMC_vrm` expressions), which the weights that
 * were set do not tell. Nothing is allocated by `writeTo`.
 */
export class VrmWeights {
  /** In the order that they are written in. */
  readonly names: readonly string[]
  readonly #expressions: readonly VrmExpression[]
  readonly #kinds: readonly Kind[]

  constructor(manager: VrmExpressions) {
    this.#expressions = [...manager.expressions]
    this.names = this.#expressions.map(({ expressionName }) => expressionName)
    this.#kinds = this.names.map((name) => {
      if (manager.blinkExpressionNames.includes(name)) return 'blink'
      if (manager.lookAtExpressionNames.includes(name)) return 'lookAt'
      return manager.mouthExpressionNames.includes(name) ? 'mouth' : null
    })
  }

  /** @param weights takes one for each name, from `offset` on. */
  writeTo(weights: Float32Array, offset: number): void {
    let blink = 1
    let lookAt = 1
    let mouth = 1
    for (let i = 0; i < this.#expressions.length; i++) {
      const expression = this.#expressions[i]
      blink -= expression.overrideBlinkAmount
      lookAt -= expression.overrideLookAtAmount
      mouth -= expression.overrideMouthAmount
    }
    for (let i = 0; i < this.#expressions.length; i++) {
      const kind = this.#kinds[i]
      const left = kind === 'blink' ? blink : kind === 'lookAt' ? lookAt : kind === 'mouth' ? mouth : 1
      const { outputWeight, isBinary } = this.#expressions[i]
      // What is on or off is off as soon as anything is taken from it.
      weights[offset + i] = isBinary && left < 1 ? 0 : outputWeight * Math.max(0, left)
    }
  }
}
