/** The part of three-vrm's `VRMExpression` that is read. */
export interface VrmExpression {
  expressionName: string
  /** Its weight, 0 or 1 where it is binary. */
  outputWeight: number
  isBinary: boolean
  /** How much it suppresses all expressions of a kind, 0..1. */
  overrideBlinkAmount: number
  overrideLookAtAmount: number
  overrideMouthAmount: number
}

/** The part of three-vrm's `VRMExpressionManager` that is read. */
export interface VrmExpressions {
  expressions: readonly VrmExpression[]
  blinkExpressionNames: readonly string[]
  lookAtExpressionNames: readonly string[]
  mouthExpressionNames: readonly string[]
}

/** Which of the three overrides an expression is subject to. */
type Kind = 'blink' | 'lookAt' | 'mouth' | null

/**
 * The weights of a VRM's expressions as they are drawn: after their overrides (VRM 1.0, `VRMC_vrm` expressions), which the
 * expressions' own weights leave out. Nothing is allocated by `writeTo`.
 */
export class VrmWeights {
  /** In the order that they are written. */
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

  /** @param weights receives one for each name, from `offset` on. */
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
