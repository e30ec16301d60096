/** Properties of three-vrm's `VRMExpression` that this module reads. */
export interface VrmExpression {
  expressionName: string
  /** Weight before overrides, 0..1. */
  outputWeight: number
  /** Whether the weight is always 0 or 1. */
  isBinary: boolean
  /** By how much this expression suppresses blink expressions, 0..1. */
  overrideBlinkAmount: number
  /** By how much this expression suppresses look-at expressions, 0..1. */
  overrideLookAtAmount: number
  /** By how much this expression suppresses mouth expressions, 0..1. */
  overrideMouthAmount: number
}

/** Properties of three-vrm's `VRMExpressionManager` that this module reads. */
export interface VrmExpressions {
  expressions: readonly VrmExpression[]
  /** Names of the blink expressions. Other expressions suppress them by `overrideBlinkAmount`. */
  blinkExpressionNames: readonly string[]
  lookAtExpressionNames: readonly string[]
  mouthExpressionNames: readonly string[]
}

/** Kind of override that suppresses an expression; null if none does. */
type Kind = 'blink' | 'lookAt' | 'mouth' | null

/** Computes the weights of VRM expressions after overrides, as VRM 1.0 specifies for `VRMC_vrm`. `writeTo` allocates nothing. */
export class VrmWeights {
  /** Names of the expressions. `writeTo` writes the weights in the same order. */
  readonly names: readonly string[]
  readonly #expressions: readonly VrmExpression[]
  readonly #kinds: readonly Kind[]

  /** @param manager expression manager. Its list of expressions is copied. The weights are read in every call of `writeTo`. */
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
   * Computes the current weights.
   *
   * @param weights receives one weight, 0..1, per name.
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
      // An override of any amount turns a binary expression off.
      weights[offset + i] = isBinary && remaining < 1 ? 0 : outputWeight * Math.max(0, remaining)
    }
  }
}
