import type { WrinkleDriver } from 'furrow'
import {
  type Contribution,
  canonicalTargetName,
  type DriverPlan,
  DriverProgram,
  type DriverState,
  inputName,
  planDrivers,
  valueSource,
} from 'furrow/internal'
import { bindInputs, bindTension } from 'furrow/internal/three'
import type { Wrinkles } from '../../../../stage/stage.ts'

/** What the face has beyond its mesh. Both maps are read whenever the drivers are evaluated. */
export interface FaceState {
  /** Numbers that an application would set, by name: age, stress. */
  readonly inputs: ReadonlyMap<string, number>
  /** Activations at rest by area, 0..1; 0 where there is none. */
  readonly resting: ReadonlyMap<string, number>
}

const MEASURED = ['target', 'joint', 'tension'] as const

/**
 * Drivers of all types on the face that is shown, as the engine runs them, but for delays: sliders follow at once, and show what an area
 * comes to.
 */
export class FaceDrivers {
  readonly list: readonly WrinkleDriver[]
  readonly #plan: DriverPlan
  readonly #face: FaceState
  readonly #program: DriverProgram
  readonly #state: DriverState
  readonly #values: ReturnType<typeof valueSource>
  readonly #read: () => void

  /** @param wrinkles null for a plain face, which has nothing to drive. */
  constructor(wrinkles: Wrinkles | null, list: readonly WrinkleDriver[], face: FaceState) {
    this.list = list
    this.#face = face
    this.#plan = planDrivers(wrinkles ? list.filter(({ type }) => type !== 'time') : [])
    this.#values = valueSource(this.#plan.inputs.value)
    const readers = wrinkles && bindInputs(wrinkles, this.#plan.inputs, bindTension)
    this.#program = new DriverProgram(this.#plan, { ...readers, value: this.#values })
    const state = this.#program.createState()
    this.#state = state
    this.#read = () => {
      if (readers) for (const kind of MEASURED) readers[kind]?.read(state.inputs[kind], 0, null)
    }
  }

  /** Areas that drivers activate or read, in the order of `evaluate`. */
  get areaNames(): readonly string[] {
    return this.#plan.areaNames
  }

  /** Activations, 0..1, in the present pose; overwritten by the next call. */
  evaluate(): Float32Array {
    const { inputs, resting } = this.#face
    const { names, initial } = this.#values
    this.#read()
    this.#state.inputs.value.set(names.map((name, i) => inputs.get(name) ?? initial[i]))
    this.#state.resting.set(this.#plan.areaNames.map((name) => resting.get(name) ?? 0))
    this.#program.evaluate(this.#state)
    return this.#state.activations
  }

  /** What each driver gives in the present pose, in their order; null for those that activate nothing. */
  contributions(): (Contribution | null)[] {
    this.evaluate()
    const { activations } = this.#program
    const indices = new Map(activations.map(({ driver }, i) => [driver, i]))
    return this.list.map((driver) => {
      const index = indices.get(driver)
      return index === undefined ? null : this.#program.explain(index, this.#state)
    })
  }

  /** Lines of text: what each driver gives to an area in the present pose, and the part of each input in it. */
  explain(area: string): string[] {
    this.evaluate()
    const lines = this.#program.activations.flatMap(({ activation }, i) => {
      if (activation.area !== area) return []
      const now = this.#program.explain(i, this.#state)
      const parts = activation.links.map(
        ({ input }, k) => `${now.links[k].toFixed(2)} by ${inputName(input)}`,
      )
      return [`${now.activation.toFixed(2)} of ${area} from`, ...parts]
    })
    return lines.length > 0 ? lines : [`${area} has no driver: only its slider moves it`]
  }

  /** Names of the blendshapes that drive an area, as on their sliders. */
  targetsOf(area: string): string[] {
    return this.#plan.activations
      .filter(({ activation }) => activation.area === area)
      .flatMap(({ activation }) => targetNames(activation.links))
  }

  /** Areas that a blendshape drives. */
  areasOf(target: string): string[] {
    const driven = this.#plan.activations.filter(({ activation }) =>
      targetNames(activation.links).includes(target),
    )
    return [...new Set(driven.map(({ activation }) => activation.area))]
  }

  /** The value of an input that an application would set. */
  input(name: string): number {
    return this.#face.inputs.get(name) ?? this.#values.initial[this.#values.names.indexOf(name)] ?? 0
  }
}

function targetNames(links: DriverPlan['activations'][number]['activation']['links']): string[] {
  return links.flatMap(({ input }) => (input.kind === 'target' ? [canonicalTargetName(input.name)] : []))
}
