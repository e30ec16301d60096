import { sentence } from '../core/error.ts'
import type { ExternalInputKind } from '../drivers/activation.ts'
import type { DriverPlan } from '../drivers/plan.ts'
import { DriverProgram, type DriverState, type InputSource } from '../drivers/program.ts'
import { valueSource } from '../drivers/sources.ts'
import type { Activations } from './activations.ts'
import type { Face } from './face.ts'
import type { FaceDrivers } from './face-drivers.ts'
import { LastInputs } from './last-inputs.ts'
import type { NamedInputs } from './named-inputs.ts'

/** Reads the inputs of one kind from an engine's objects. */
export interface InputReader<Engine> extends InputSource {
  /**
   * Reads the inputs of one face. It runs in every frame and should not allocate.
   *
   * @param values receives `count` numbers.
   * @param instance index of the instance; 0 for other meshes.
   * @param engine what draws the frame, e.g. a renderer; null if nothing is drawn.
   */
  read(values: Float64Array, instance: number, engine: Engine | null): void
}

/** Kinds of inputs that an engine measures. */
export type MeasuredKind = Exclude<ExternalInputKind, 'value'>

/** A reader for each kind that a plan has. */
export type InputReaders<Engine> = { readonly [K in MeasuredKind]?: InputReader<Engine> }

const MEASURED = ['target', 'joint', 'tension'] as const satisfies readonly MeasuredKind[]

/** Index of an area that the face does not have. */
const NO_AREA = 0xffff

/** Runs drivers of any type on the faces of one mesh. Allocates nothing after the first frame. */
export class DriverRuntime<Engine> implements FaceDrivers<Engine> {
  readonly plan: DriverPlan
  readonly #bind: () => InputReaders<Engine>
  readonly #values: InputSource
  /** Per value of that source: the value of each face. */
  readonly #named: readonly Float64Array[]
  readonly #label: string
  #bound: Bound<Engine> | null = null
  /** Per face. */
  readonly #states: DriverState[] = []
  /** Per face: when its inputs were last read, in milliseconds. */
  readonly #times: Float64Array
  /** Per area of the plan: its index among the faces' areas. */
  readonly #indices: Uint16Array
  /** The areas that `#indices` was made for. */
  #slots: Face['slots'] | null = null

  /**
   * @param bind finds the inputs of the plan on the mesh; called at the first frame, or by `bind`.
   * @param inputs what the application sets.
   * @param faces number of faces.
   * @param label names the mesh in warnings.
   */
  constructor(
    plan: DriverPlan,
    bind: () => InputReaders<Engine>,
    inputs: NamedInputs,
    faces: number,
    label: string,
  ) {
    this.plan = plan
    this.#bind = bind
    this.#label = label
    this.#times = new Float64Array(faces)
    this.#indices = new Uint16Array(plan.areaNames.length)
    const values = valueSource(plan.inputs.value)
    this.#values = values
    // Declared here, so that they can be read before the first frame.
    this.#named = values.names.map((name, i) => inputs.declare(name, values.initial[i]))
  }

  get movedAreas(): ReadonlySet<string> {
    return this.plan.movedAreas
  }

  /** Finds the inputs, unless it has done so, and warns of those that the mesh lacks. */
  bind(): Bound<Engine> {
    // Apart from what it does once: a function with closures allocates their context whenever it is called.
    return this.#bound ?? this.#findInputs()
  }

  #findInputs(): Bound<Engine> {
    const { plan } = this
    const readers = this.#bind()
    const program = new DriverProgram(plan, { ...readers, value: this.#values })
    const read = program.createState()
    const bound: Bound<Engine> = {
      program,
      read,
      last: new LastInputs(this.#times.length, read.values.length),
      readers: MEASURED.flatMap((kind) => {
        const reader = readers[kind]
        return reader && plan.inputs[kind].length > 0 ? { kind, reader } : []
      }),
    }
    this.#bound = bound
    this.#warn([
      ...plan.unknownTypes.map((type) => `driver of type "${type}"`),
      ...program.missing,
      ...plan.cyclicAreas.map((area) => `area "${area}", which drives itself,`),
    ])
    return bound
  }

  readInputs(faces: readonly Face[], clock: { now(): number }, engine: Engine | null): void {
    const { program, readers, read, last } = this.bind()
    const named = this.#named
    const needsTime = this.plan.activationFilters.length > 0
    const now = needsTime ? clock.now() : 0
    for (let i = 0; i < faces.length; i++) {
      for (let k = 0; k < readers.length; k++) readers[k].reader.read(read.inputs[readers[k].kind], i, engine)
      for (let k = 0; k < named.length; k++) read.inputs.value[k] = named[k][i]
      last.take(i, read.values)
      this.#states[i] ??= program.createState()
      if (!needsTime) continue
      this.#states[i].seconds[0] = (now - this.#times[i]) / 1000
      this.#times[i] = now
    }
  }

  evaluate(faces: readonly Face[]): void {
    if (faces[0].slots !== this.#slots) this.#findAreas(faces[0])
    const { program, last } = this.bind()
    for (let i = 0; i < faces.length; i++) {
      const state = this.#states[i]
      if (!last.check(i, faces[i]) && state.isSettled) continue
      last.isDue[i] = 1
      last.get(i, state.values)
      const { values } = faces[i].resting
      for (let k = 0; k < this.#indices.length; k++) {
        state.resting[k] = this.#indices[k] === NO_AREA ? 0 : values[this.#indices[k]]
      }
      program.evaluate(state)
    }
  }

  apply(faces: readonly Face[]): void {
    const { last } = this.bind()
    for (let i = 0; i < faces.length; i++) {
      if (!last.isDue[i]) continue
      setAll(faces[i].activations, this.#indices, this.#states[i])
      last.settle(i, faces[i])
    }
  }

  /** Resolves the areas, which may be added and removed, and warns of those that are missing. */
  #findAreas({ slots, activations }: Face): void {
    this.#slots = slots
    const { names } = activations
    const missing: string[] = []
    for (const [i, name] of this.plan.areaNames.entries()) {
      const index = names.indexOf(name)
      this.#indices[i] = index < 0 ? NO_AREA : index
      if (index < 0) missing.push(`area "${name}"`)
    }
    this.#warn(missing)
  }

  #warn(missing: readonly string[]): void {
    if (missing.length === 0) return
    console.warn(
      sentence({
        who: 'Wrinkles',
        what: `drivers of mesh "${this.#label}" use what is not available`,
        value: missing.join(', '),
        remedy: 'all other drivers work',
      }),
    )
  }
}

interface Bound<Engine> {
  program: DriverProgram
  /** Receives the inputs of one face after another. */
  read: DriverState
  /** What it received. */
  last: LastInputs
  readers: readonly { kind: MeasuredKind; reader: InputReader<Engine> }[]
}

function setAll(activations: Activations, indices: Uint16Array, { activations: values }: DriverState): void {
  for (let i = 0; i < indices.length; i++)
    if (indices[i] !== NO_AREA) activations.setAt(indices[i], values, i)
}
