import { sentence } from '../core/error.ts'
import { type Expression, expressionsOf } from '../drivers/expression/expression.ts'
import { faceExpressions, firstOfEachName } from '../drivers/expression/face-expressions.ts'
import { EXPRESSIONS } from '../drivers/expression/presets.ts'
import { checkWrinkles } from './check-wrinkles.ts'
import { type Easing, type ExpressionChoice, ExpressionMix } from './expression-mix.ts'
import type { BindTargets, TargetBinding } from './target-binding.ts'
import type { WrinkleFaces } from './wrinkle-faces.ts'

/** `ExpressionPlayer`, independent of the engine. */
export class ExpressionPlayerBase {
  /** Names of the expressions that the face can show, for buttons. The initial one comes first. */
  readonly expressionNames: readonly string[]
  readonly #mix: ExpressionMix
  #last = 0
  readonly #wrinkles: WrinkleFaces | undefined
  readonly #bindings: TargetBinding[]

  /**
   * @param wrinkles of the face; undefined for a face without.
   * @param bind finds blendshapes on the meshes of the face.
   * @param expressions the first is the initial one; by default those that the face can show.
   */
  constructor(wrinkles: WrinkleFaces | undefined, bind: BindTargets, expressions?: readonly Expression[]) {
    if (wrinkles !== undefined) checkWrinkles(wrinkles, 'ExpressionPlayer', 'wrinkles of the face')
    const authored = wrinkles ? expressionsOf(wrinkles.drivers) : []
    const shown = expressions ?? expressionsOfFace(authored, wrinkles, bind)
    // A page may play `happy` on any avatar: one that lacks the shapes stays as it is.
    const others = authored.length > 0 ? authored : EXPRESSIONS
    const restOf = (area: string) => wrinkles?.getArea(area)?.activation ?? 0
    this.#mix = new ExpressionMix(expressions ?? firstOfEachName([...shown, ...others]), restOf)
    this.expressionNames = shown.map(({ name }) => name)
    this.#wrinkles = wrinkles
    this.#bindings = bind(this.#mix.targetNames)
    const bound = new Set(this.#bindings.map(({ name }) => this.#mix.targetNames[name]))
    const named = (what: 'targets' | 'activations') => new Set(shown.flatMap((one) => Object.keys(one[what])))
    warnOfMissing([
      ...[...named('targets')].filter((name) => !bound.has(name)),
      ...[...named('activations')].filter((name) => wrinkles && !wrinkles.hasArea(name)),
    ])
  }

  /** Whether a transition is going on, so that the next frame will differ. */
  get isPlaying(): boolean {
    return !this.#mix.still
  }

  /**
   * Starts a transition from the current face, sliders included, to an expression, or to several at once, which are added:
   * `{ happy: 0.6, surprised: 0.4 }`.
   *
   * @param choice names and weights, 0..1.
   * @param seconds duration, 0.25 by default; 0 takes effect at once.
   * @param easing linear by default.
   * @throws FurrowError when no expression has that name, a weight is not within 0..1, or the time is negative, NaN or infinite.
   */
  play(choice: ExpressionChoice, seconds = 0.25, easing: Easing = 'linear'): void {
    this.#read()
    this.#last = performance.now()
    this.#mix.play(choice, seconds, easing)
    if (seconds === 0) this.#write()
  }

  /**
   * Advances the transition, if any. Call it once per frame.
   *
   * @param delta seconds since the last frame; measured by default.
   */
  update(delta = this.#sinceLast()): void {
    if (this.#mix.still) return
    this.#mix.update(delta)
    this.#write()
  }

  /** Seconds since the last frame, or since `play`. */
  #sinceLast(): number {
    const now = performance.now()
    const delta = (now - this.#last) / 1000
    this.#last = now
    return delta
  }

  #read(): void {
    const { targets, areaNames, activations } = this.#mix
    for (const { influences, target, name } of this.#bindings) targets[name] = influences[target]
    for (const [index, name] of areaNames.entries()) {
      if (!this.#wrinkles?.hasArea(name)) continue
      // Of areas that are not driven, without what age and other inputs add.
      activations[index] = this.#wrinkles.isDriven(name)
        ? this.#wrinkles.getActivation(name)
        : this.#wrinkles.getRestingActivation(name)
    }
  }

  #write(): void {
    const { targets, areaNames, activations } = this.#mix
    for (const { influences, target, name } of this.#bindings) influences[target] = targets[name]
    // A player may outlive the wrinkles, and still moves the blendshapes.
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
    sentence({
      who: 'ExpressionPlayer',
      problem: 'this face lacks blendshapes or areas',
      value: names.join(', '),
      remedy: 'expressions play without them',
    }),
  )
}
