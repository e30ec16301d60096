import { isObject, wrongArgument } from '../core/argument.ts'
import { FurrowError } from '../core/error.ts'
import { didYouMean } from '../core/nearest-name.ts'
import type { Expression } from '../drivers/expression/expression.ts'

const WHO = 'ExpressionMix'

/** Easing functions. They map the elapsed fraction of a transition's duration, 0..1, to its progress, 0..1. */
export const EASINGS = {
  /** Constant speed. */
  linear: (t: number) => t,
  /** Starts slowly: `t * t`. */
  easeIn: (t: number) => t * t,
  /** Ends slowly: `t * (2 - t)`. */
  easeOut: (t: number) => t * (2 - t),
  /** Starts and ends slowly (smoothstep): `t * t * (3 - 2 * t)`. */
  easeInOut: (t: number) => t * t * (3 - 2 * t),
} as const

/** Name of an easing in `EASINGS`, or a function that maps the elapsed fraction of the duration, 0..1, to the progress, 0..1. */
export type Easing = keyof typeof EASINGS | ((t: number) => number)

/** Name of one expression, or several expressions with weights, 0..1, such as `{ happy: 0.6, surprised: 0.4 }`. */
export type ExpressionChoice = string | Readonly<Record<string, number>>

/**
 * Computes transitions between facial expressions. An expression consists of blendshape weights and activations of areas. `update`
 * allocates nothing, unless a custom easing does.
 */
export class ExpressionMix {
  /** Names of the blendshapes used by the expressions. */
  readonly targetNames: readonly string[]
  /** Names of the areas used by the expressions. */
  readonly areaNames: readonly string[]
  /** Current weights, in the order of `targetNames`. */
  readonly targets: Float32Array
  /** Current activations, in the order of `areaNames`. */
  readonly activations: Float32Array

  readonly #expressions: ReadonlyMap<string, Pose>
  /** Weights and activations of the resting face. */
  readonly #rest: Pose
  readonly #from: Pose
  readonly #to: Pose
  /** Null for a linear easing, to avoid a call: V8 may allocate memory for a number that is passed to a function. */
  #easing: ((t: number) => number) | null = null
  #duration = 0
  /** Elapsed seconds at index 0, and progress, 0..1, at index 1. An array is used, because V8 may allocate memory for a number in a field. */
  readonly #now = new Float64Array(2)

  /**
   * @param expressions at least one expression. The first is the initial state.
   * @param restOf returns the resting activation of an area. It is used for expressions that do not set the area. Default: 0.
   * @throws FurrowError if the list is empty or an expression is malformed.
   */
  constructor(expressions: readonly Expression[], restOf: (area: string) => number = () => 0) {
    for (const expression of Array.isArray(expressions) ? expressions : [expressions])
      checkExpression(expression)
    if (expressions.length === 0) {
      throw new FurrowError({
        who: 'ExpressionMix',
        problem: 'no expressions',
        value: 0,
        limit: 'at least 1',
        remedy: 'pass a list such as EXPRESSIONS',
      })
    }
    this.targetNames = union(expressions.map((expression) => expression.targets))
    this.areaNames = union(expressions.map((expression) => expression.activations))
    this.#rest = {
      targets: new Float32Array(this.targetNames.length),
      activations: Float32Array.from(this.areaNames, restOf),
    }
    this.#expressions = new Map(
      expressions.map(({ name, targets, activations }) => [
        name,
        {
          targets: Float32Array.from(this.targetNames, (target) => targets[target] ?? 0),
          activations: Float32Array.from(this.areaNames, (area) => activations[area] ?? restOf(area)),
        },
      ]),
    )
    const first = this.#expressions.get(expressions[0].name)!
    this.targets = first.targets.slice()
    this.activations = first.activations.slice()
    this.#from = { targets: this.targets.slice(), activations: this.activations.slice() }
    this.#to = { targets: this.targets.slice(), activations: this.activations.slice() }
  }

  /** Whether the transition has ended. */
  get isFinished(): boolean {
    return this.#now[0] >= this.#duration
  }

  /**
   * Starts a transition from the current values to one or several expressions. For several, the difference of each expression from the
   * resting face is multiplied by its weight and added to the resting face. The sum is clamped to 0..1 after each addition.
   *
   * @param choice name of one expression, or names and weights of several.
   * @param seconds duration. The default, 0, applies the choice immediately.
   * @param easing default `linear`.
   * @throws FurrowError if a name or the easing is unknown, a weight is outside 0..1, or the duration is negative, NaN or infinite.
   */
  play(choice: ExpressionChoice, seconds = 0, easing: Easing = 'linear'): void {
    if (typeof choice !== 'string' && !isObject(choice)) {
      throw wrongArgument(WHO, 'expression', choice, 'a name, or an object of names and weights')
    }
    const ease = typeof easing === 'function' ? easing : EASINGS[easing]
    if (!ease) throw wrongArgument(WHO, 'easing', easing, `${Object.keys(EASINGS).join(', ')}, or a function`)
    const weights = typeof choice === 'string' ? { [choice]: 1 } : choice
    for (const [name, weight] of Object.entries(weights)) this.#check(name, weight)
    if (!(seconds >= 0 && seconds < Infinity)) {
      throw new FurrowError({
        code: 'out-of-range',
        who: 'ExpressionMix',
        problem: 'duration out of range',
        value: seconds,
        limit: 'at least 0 seconds',
        remedy: 'pass the duration of the transition, e.g. 0.3',
      })
    }
    for (const values of ['targets', 'activations'] as const) {
      this.#from[values].set(this[values])
      const rest = this.#rest[values]
      this.#to[values].set(rest)
      for (const [name, weight] of Object.entries(weights)) {
        const own = this.#expressions.get(name)![values]
        const sum = this.#to[values]
        for (let i = 0; i < sum.length; i++) {
          sum[i] = Math.min(1, Math.max(0, sum[i] + weight * (own[i] - rest[i])))
        }
      }
    }
    this.#easing = easing === 'linear' ? null : ease
    this.#duration = seconds
    this.#now[0] = 0
    if (seconds === 0) this.update(0)
  }

  /**
   * Advances the transition.
   *
   * @param delta seconds since the last call.
   * @throws FurrowError if `delta` is negative or NaN.
   */
  update(delta: number): void {
    if (!(delta >= 0)) throw wrongArgument(WHO, 'delta', delta, 'at least 0 seconds')
    // V8 inlines this method only if it is short. Inlining avoids an allocation for `delta`.
    this.#now[0] += delta
    this.#advance()
  }

  #advance(): void {
    const now = this.#now
    if (now[0] > this.#duration) now[0] = this.#duration
    now[1] = this.isFinished ? 1 : now[0] / this.#duration
    if (this.#easing && !this.isFinished) now[1] = this.#easing(now[1])
    this.#interpolate('targets')
    this.#interpolate('activations')
  }

  #interpolate(values: keyof Pose): void {
    const t = this.#now[1]
    const from = this.#from[values]
    const to = this.#to[values]
    const out = this[values]
    for (let i = 0; i < out.length; i++) out[i] = from[i] * (1 - t) + to[i] * t
  }

  #check(name: string, weight: number): void {
    if (!this.#expressions.has(name)) {
      const names = [...this.#expressions.keys()]
      throw new FurrowError({
        code: 'unknown-name',
        who: 'ExpressionMix',
        problem: 'unknown expression',
        value: name,
        limit: names.join(', '),
        remedy: didYouMean(name, names, 'use one of these names, or pass your own list of expressions'),
      })
    }
    if (weight >= 0 && weight <= 1) return
    throw new FurrowError({
      code: 'out-of-range',
      who: 'ExpressionMix',
      problem: `weight of "${name}" out of range`,
      value: weight,
      limit: '0 to 1',
      remedy: 'correct the weight',
    })
  }
}

function checkExpression(expression: Expression): void {
  const isValid = (values: unknown) => isObject(values) && Object.values(values).every(Number.isFinite)
  if (isObject(expression) && isValid(expression.targets) && isValid(expression.activations)) return
  throw wrongArgument(WHO, 'expression', expression, 'an object with name, targets and activations')
}

interface Pose {
  targets: Float32Array
  activations: Float32Array
}

function union(records: readonly Readonly<Record<string, number>>[]): string[] {
  return [...new Set(records.flatMap((record) => Object.keys(record)))]
}
