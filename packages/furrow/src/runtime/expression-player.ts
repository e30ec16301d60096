import { formatProblem } from '../core/error.ts'
import { type Expression, expressionsOf } from '../drivers/expression/expression.ts'
import { faceExpressions, uniqueByName } from '../drivers/expression/face-expressions.ts'
import { EXPRESSIONS } from '../drivers/expression/presets.ts'
import { checkWrinkles } from './check-wrinkles.ts'
import { type Easing, type ExpressionChoice, ExpressionMix } from './expression-mix.ts'
import type { BindTargets, TargetBinding } from './target-binding.ts'
import type { WrinkleFaces } from './wrinkle-faces.ts'

/** Plays transitions between facial expressions on the blendshapes and wrinkles of a face. Base class for `ExpressionPlayer` of each engine. */
export class ExpressionPlayerBase {
  /** Names of the expressions that the face can show. The initial expression comes first. */
  readonly expressionNames: readonly string[]
  readonly #mix: ExpressionMix
  #last = 0
  readonly #wrinkles: WrinkleFaces | undefined
  readonly #bindings: TargetBinding[]

  /**
   * @param wrinkles wrinkles of the face, if it has any.
   * @param bind finds blendshapes on the meshes of the face.
   * @param expressions expressions to play; the first is the initial one. Default: all expressions that the face can show.
   */
  constructor(wrinkles: WrinkleFaces | undefined, bind: BindTargets, expressions?: readonly Expression[]) {
    if (wrinkles !== undefined) checkWrinkles(wrinkles, 'ExpressionPlayer', 'wrinkles of the face')
    const authored = wrinkles ? expressionsOf(wrinkles.drivers) : []
    const shown = expressions ?? expressionsOfFace(authored, wrinkles, bind)
    // Pages may play presets such as `happy` on any avatar. An avatar without the needed blendshapes does not move.
    const others = authored.length > 0 ? authored : EXPRESSIONS
    const restOf = (area: string) => wrinkles?.getArea(area)?.activation ?? 0
    this.#mix = new ExpressionMix(expressions ?? uniqueByName([...shown, ...others]), restOf)
    this.expressionNames = shown.map(({ name }) => name)
    this.#wrinkles = wrinkles
    this.#bindings = bind(this.#mix.targetNames)
    const bound = new Set(this.#bindings.map(({ name }) => this.#mix.targetNames[name]))
    const namesIn = (field: 'targets' | 'activations') =>
      new Set(shown.flatMap((expression) => Object.keys(expression[field])))
    warnOfMissing([
      ...[...namesIn('targets')].filter((name) => !bound.has(name)),
      ...[...namesIn('activations')].filter((name) => wrinkles && !wrinkles.hasArea(name)),
    ])
  }

  /** Whether a transition is running. */
  get isPlaying(): boolean {
    return !this.#mix.isFinished
  }

  /**
   * Starts a transition from the current face to one expression, or to a sum such as `{ happy: 0.6, surprised: 0.4 }`.
   *
   * @param choice name of one expression, or names and weights, 0..1, of several.
   * @param seconds duration, default 0.25. A duration of 0 applies the choice immediately.
   * @param easing default `linear`.
   * @throws FurrowError if a name or the easing is unknown, a weight is outside 0..1, or the duration is negative, NaN or infinite.
   */
  play(choice: ExpressionChoice, seconds = 0.25, easing: Easing = 'linear'): void {
    this.#read()
    this.#last = performance.now()
    this.#mix.play(choice, seconds, easing)
    if (seconds === 0) this.#write()
  }

  /**
   * Advances the transition. Call once per frame.
   *
   * @param delta seconds since the last call. By default, the time is measured.
   */
  update(delta = this.#sinceLast()): void {
    if (this.#mix.isFinished) return
    this.#mix.update(delta)
    this.#write()
  }

  /** Returns the seconds since this method or `play` was last called. */
  #sinceLast(): number {
    const now = performance.now()
    const delta = (now - this.#last) / 1000
    this.#last = now
    return delta
  }

  #read(): void {
    const wrinkles = this.#wrinkles
    const { targets, areaNames, activations } = this.#mix
    for (const { influences, target, name } of this.#bindings) targets[name] = influences[target]
    for (const [index, name] of areaNames.entries()) {
      if (!wrinkles?.hasArea(name)) continue
      // Inputs such as age add to the resting activation of an area that no motion drives. The transition must start from the resting
      // activation, because the current activation already contains these inputs.
      const isAddedTo = wrinkles.driven && !wrinkles.isDriven(name)
      activations[index] = isAddedTo ? wrinkles.getRestingActivation(name) : wrinkles.getActivation(name)
    }
  }

  #write(): void {
    const { targets, areaNames, activations } = this.#mix
    for (const { influences, target, name } of this.#bindings) influences[target] = targets[name]
    // The player moves blendshapes even after its wrinkles were disposed.
    if (this.#wrinkles?.isDisposed === false) this.#wrinkles.setActivations(areaNames, activations)
  }
}

function expressionsOfFace(
  authored: readonly Expression[],
  wrinkles: WrinkleFaces | undefined,
  bind: BindTargets,
): Expression[] {
  return faceExpressions({
    authored,
    vrm: wrinkles?.expressions.slice(authored.length) ?? [],
    targetsAmong: (names) => new Set(bind(names).map(({ name }) => names[name]!)),
    hasArea: (name) => wrinkles?.hasArea(name) ?? false,
  })
}

function warnOfMissing(names: string[]): void {
  if (names.length === 0) return
  console.warn(
    formatProblem({
      who: 'ExpressionPlayer',
      problem: 'the face lacks blendshapes or areas of the expressions',
      value: names.join(', '),
      remedy: 'expressions play without them',
    }),
  )
}
