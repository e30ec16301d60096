/** The part of three-vrm's `VRMExpression` that is read. */
export interface VrmExpression {
  /** Its name. */
  expressionName: string
  /** Its weight before overrides, 0..1; 0 or 1 if it is binary. */
  outputWeight: number
  /** Whether its weight is only ever 0 or 1. */
  isBinary: boolean
  /** How much it suppresses expressions that blink, 0..1. */
  overrideBlinkAmount: number
  /** How much it suppresses expressions that move the eyes, 0..1. */
  overrideLookAtAmount: number
  /** How much it suppresses expressions of the mouth, 0..1. */
  overrideMouthAmount: number
}

/** The part of three-vrm's `VRMExpressionManager` that is read. */
export interface VrmExpressions {
  /** All expressions. */
  expressions: readonly VrmExpression[]
  /** Names of those that each override suppresses. */
  blinkExpressionNames: readonly string[]
  lookAtExpressionNames: readonly string[]
  mouthExpressionNames: readonly string[]
}

/** Which of the three overrides an expression is subject to. */
type Kind = 'blink' | 'lookAt' | 'mouth' | null

/**
 * The weights of a VRM's expressions after their overrides (VRM 1.0, `VRMC_vrm` expressions), as they are drawn. `writeTo` allocates
 * nothing.
 */
export class VrmWeights {
  /** Names of the expressions, in the order in which `writeTo` writes them. */
  readonly names: readonly string[]
  readonly #expressions: readonly VrmExpression[]
  readonly #kinds: readonly Kind[]

  /** @param manager its list of expressions is copied; weights are read in every `writeTo`. */
  constructor(manager: VrmExpressions) {
    this.#expressions = [...manager.expressions]
    this.names = this.#expressions.map(({ expressionName }) => expressionName)
    this.#kinds = this.names.map((name) => {
      if (manager.blinkExpressionNames.includes(name)) return 'blink'
      if (manager.lookAtExpressionNames.includes(name)) return 'lookAt'
      return manager.mouthExpressionNames.includes(name) ? 'mouth' : null
    })
  }

  /**
   * Writes the current weights, 0..1.
   *
   * @param weights receives one for each name.
   * @param offset index of the first.
   */
  writeTo(weights: Float32Array | Float64Array, offset: number): void {
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
      const remaining = kind === 'blink' ? blink : kind === 'lookAt' ? lookAt : kind === 'mouth' ? mouth : 1
      const { outputWeight, isBinary } = this.#expressions[i]
      // A binary expression is off as soon as anything overrides it.
      weights[offset + i] = isBinary && remaining < 1 ? 0 : outputWeight * Math.max(0, remaining)
    }
  }
}
