import {
  canonicalTargetName,
  DriverProgram,
  type DriverState,
  driversOf,
  explain,
  planDrivers,
  targetSource,
  type WrinkleDriver,
} from 'furrow'
import type { Mesh } from 'three'

/** The drivers of a face's wrinkles: what they activate in its present pose, and why. */
export class FaceDrivers {
  readonly list: readonly WrinkleDriver[]
  readonly #skin: Mesh
  readonly #targetNames: readonly string[]
  readonly #program: DriverProgram
  readonly #state: DriverState

  constructor(skin: Mesh, list: readonly WrinkleDriver[]) {
    this.list = list
    this.#skin = skin
    this.#targetNames = Object.keys(skin.morphTargetDictionary ?? {})
    const plan = planDrivers(driversOf('morph', list))
    this.#program = new DriverProgram(plan, { target: targetSource(plan.inputs.target, this.#targetNames) })
    this.#state = this.#program.createState()
  }

  /** Areas that blendshapes drive, in the order of `evaluate`. */
  get areaNames(): readonly string[] {
    return this.#program.plan.areaNames
  }

  /** Activations that the present blendshape weights give: the same array at every call. */
  evaluate(): Float32Array {
    this.#state.inputs.target.set(this.#skin.morphTargetInfluences ?? [])
    this.#program.evaluate(this.#state)
    return this.#state.activations
  }

  /** Names of the blendshapes that drive an area, as on their dials. */
  targetsOf(area: string): string[] {
    return driversOf('morph', this.list)
      .filter((driver) => driver.area === area)
      .flatMap(({ targets }) => targets.map(({ name }) => canonicalTargetName(name)))
  }

  /** Areas that a blendshape drives, by its name on its dial. */
  areasOf(target: string): string[] {
    const drivers = driversOf('morph', this.list).filter(({ targets }) =>
      targets.some(({ name }) => canonicalTargetName(name) === target),
    )
    return [...new Set(drivers.map(({ area }) => area))]
  }

  /** Lines of text: the present activation of an area by each of its drivers, and the part of each input in it. */
  explain(area: string): string[] {
    const situation = { targetNames: this.#targetNames, weights: this.#skin.morphTargetInfluences ?? [] }
    const [explanation] = explain(this.list, [{ name: area }], situation)
    if (explanation.parts.length === 0) return [`${area} has no driver: only its slider moves it`]
    return explanation.parts.flatMap(({ activation, links }) => [
      `${activation.toFixed(2)} of ${area} from`,
      ...links.map(({ link, value }) => `${value.toFixed(2)} by ${link.name}`),
    ])
  }
}
