import type { WrinkleDriver } from 'furrow'
import {
  type Contribution,
  canonicalTargetName,
  type DriverPlan,
  DriverProgram,
  type DriverState,
  planDrivers,
  valueSource,
} from 'furrow/internal'
import { bindInputs, bindTension } from 'furrow/internal/three'
import type { Wrinkles } from '../../../../stage/stage.ts'

/** Driver inputs that do not come from the mesh. Each evaluation of the drivers reads them. */
export interface FaceState {
  /** Values of custom inputs, such as age or stress. The keys are the names of the inputs. */
  readonly inputs: ReadonlyMap<string, number>
  /** Activations of areas at rest, 0..1. Default per area: 0. */
  readonly resting: ReadonlyMap<string, number>
}

const MEASURED = ['target', 'joint', 'tension'] as const

/** Evaluates the drivers of the face. Omits drivers of type `time`, which delay activations, so that sliders show the final activation immediately. */
export class FaceDrivers {
  readonly list: readonly WrinkleDriver[]
  readonly #plan: DriverPlan
  readonly #face: FaceState
  readonly #program: DriverProgram
  readonly #state: DriverState
  readonly #values: ReturnType<typeof valueSource>
  readonly #read: () => void

  /** @param wrinkles wrinkles of the face. If null, no area is driven. */
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

  /** Areas that drivers activate or read, in the order of the activations that `evaluate` returns. */
  get areaNames(): readonly string[] {
    return this.#plan.areaNames
  }

  /** Returns activations, 0..1, in the current pose. The next call overwrites the returned array. */
  evaluate(): Float32Array {
    const { inputs, resting } = this.#face
    const { names, initial } = this.#values
    this.#read()
    this.#state.inputs.value.set(names.map((name, i) => inputs.get(name) ?? initial[i]))
    this.#state.resting.set(this.#plan.areaNames.map((name) => resting.get(name) ?? 0))
    this.#program.evaluate(this.#state)
    return this.#state.activations
  }

  /** Returns the contribution of each driver in the current pose, with null for drivers that activate no area. */
  contributions(): (Contribution | null)[] {
    this.evaluate()
    const { activations } = this.#program
    const indices = new Map(activations.map(({ driver }, i) => [driver, i]))
    return this.list.map((driver) => {
      const index = indices.get(driver)
      return index === undefined ? null : this.#program.explain(index, this.#state)
    })
  }

  /** Returns the blendshapes that drive an area, named like their dials. */
  targetsOf(area: string): string[] {
    return this.#plan.activations
      .filter(({ activation }) => activation.area === area)
      .flatMap(({ activation }) => targetNames(activation.links))
  }

  /** Returns the areas driven by a blendshape. */
  areasOf(target: string): string[] {
    const driven = this.#plan.activations.filter(({ activation }) =>
      targetNames(activation.links).includes(target),
    )
    return [...new Set(driven.map(({ activation }) => activation.area))]
  }

  input(name: string): number {
    return this.#face.inputs.get(name) ?? this.#values.initial[this.#values.names.indexOf(name)] ?? 0
  }
}

function targetNames(links: DriverPlan['activations'][number]['activation']['links']): string[] {
  return links.flatMap(({ input }) => (input.kind === 'target' ? [canonicalTargetName(input.name)] : []))
}
