import type { Object3D } from 'three'
import { sentence } from '../core/error.ts'
import { type Easing, type Expression, type ExpressionChoice, ExpressionMix } from '../drivers/expression.ts'
import { EXPRESSIONS } from '../drivers/expressions.ts'
import { bindTargets, type TargetBinding } from './sources/bind-targets.ts'
import type { WrinklesBase } from './wrinkles-base.ts'

/**
 * Plays expressions on a face: blendshapes on every mesh that has them, and activations on its wrinkles.
 * Call `update` once per frame; while the face is still it writes nothing, so sliders may move it too.
 */
export class ExpressionPlayer {
  readonly #mix: ExpressionMix
  #last = 0
  readonly #wrinkles: WrinklesBase
  readonly #bindings: TargetBinding[]

  /**
   * @param face any object above the meshes that move: head, eyes, teeth, lashes.
   * @param expressions the first is the one it starts from; unless told those of the file, or `EXPRESSIONS` where it has none.
   * @throws FurrowError when nothing under `face` has morph targets. Names of an expression that no mesh and no
   *   area has are left out with one warning.
   */
  constructor(face: Object3D, wrinkles: WrinklesBase, expressions?: readonly Expression[]) {
    const own = wrinkles.expressions.length > 0 ? wrinkles.expressions : EXPRESSIONS
    this.#mix = new ExpressionMix(expressions ?? own)
    this.#wrinkles = wrinkles
    this.#bindings = bindTargets(face, this.#mix.targetNames, 'ExpressionPlayer')
    const bound = new Set(this.#bindings.map(({ weight }) => this.#mix.targetNames[weight]))
    warnOfMissing([
      ...this.#mix.targetNames.filter((name) => !bound.has(name)),
      ...this.#mix.areaNames.filter((name) => !wrinkles.hasArea(name)),
    ])
  }

  /**
   * Moves to an expression from wherever the face is now, sliders included; or to several at once, which add up:
   * `{ happy: 0.6, surprised: 0.4 }`.
   *
   * @param seconds time to get there, 0.25 unless told.
   * @param easing linear unless told.
   * @throws FurrowError when no expression has that name, or a weight is not within 0..1.
   */
  play(choice: ExpressionChoice, seconds = 0.25, easing: Easing = 'linear'): void {
    this.#read()
    this.#last = performance.now()
    this.#mix.play(choice, seconds, easing)
    if (seconds === 0) this.#write()
  }

  /** @param delta seconds since the last frame; measured when absent. */
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
    for (const { influences, target, weight } of this.#bindings) targets[weight] = influences[target]
    for (const [index, name] of areaNames.entries()) {
      if (!this.#wrinkles.hasArea(name)) continue
      // Without what age adds to it.
      activations[index] = this.#wrinkles.isDriven(name)
        ? this.#wrinkles.getActivation(name)
        : this.#wrinkles.getRestingActivation(name)
    }
  }

  #write(): void {
    const { targets, areaNames, activations } = this.#mix
    for (const { influences, target, weight } of this.#bindings) influences[target] = targets[weight]
    this.#wrinkles.setActivations(areaNames, activations)
  }
}

function warnOfMissing(names: string[]): void {
  if (names.length === 0) return
  console.warn(
    sentence({
      who: 'ExpressionPlayer',
      what: 'blendshapes or areas that this face does not have',
      value: names.join(', '),
      remedy: 'expressions play without them',
    }),
  )
}
