/** Required part of three-vrm's `VRMExpression`. */
export interface VrmExpression {
  /** Name of the expression. */
  expressionName: string
  /** Weight before overrides, 0..1; 0 or 1 for binary expressions. */
  outputWeight: number
  /** Whether the weight is always 0 or 1. */
  isBinary: boolean
  /** Suppression of blink expressions, 0..1. */
  overrideBlinkAmount: number
  /** Suppression of look-at expressions, 0..1. */
  overrideLookAtAmount: number
  /** Suppression of mouth expressions, 0..1. */
  overrideMouthAmount: number
}

/** Required part of three-vrm's `VRMExpressionManager`. */
export interface VrmExpressions {
  /** All expressions. */
  expressions: readonly VrmExpression[]
  /** Names of expressions that the blink override suppresses. */
  blinkExpressionNames: readonly string[]
  lookAtExpressionNames: readonly string[]
  mouthExpressionNames: readonly string[]
}

/** Override that suppresses an expression. */
type Kind = 'blink' | 'lookAt' | 'mouth' | null

/** Weights of VRM expressions after overrides (VRM 1.0, `VRMC_vrm` expressions). `writeTo` allocates nothing. */
export class VrmWeights {
  /** Names of the expressions, in the order of `writeTo`. */
  readonly names: readonly string[]
  readonly #expressions: readonly VrmExpression[]
  readonly #kinds: readonly Kind[]

  /** @param manager expression manager. The list of expressions is copied; weights are read in every `writeTo`. */
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
   * @param weights receives one weight per name.
   * @param offset index of the first weight.
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
      // Any override turns a binary expression off.
      weights[offset + i] = isBinary && remaining < 1 ? 0 : outputWeight * Math.max(0, remaining)
    }
  }
}
