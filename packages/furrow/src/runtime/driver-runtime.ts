import { formatProblem } from '../core/error.ts'
import type { ExternalInputKind } from '../drivers/activation.ts'
import { type DriverPart, partsByArea } from '../drivers/explain.ts'
import type { DriverPlan } from '../drivers/plan.ts'
import { DriverProgram, type DriverState, type InputSource } from '../drivers/program.ts'
import { valueSource } from '../drivers/sources.ts'
import type { Face } from './face.ts'
import { LastInputs } from './last-inputs.ts'
import type { NamedInputs } from './named-inputs.ts'

/** Reads inputs of one kind (blendshape weights, joints or tension) from an engine's objects. */
export interface InputReader<Engine> extends InputSource {
  /**
   * Reads the inputs of one face. This method runs in every frame and should not allocate.
   *
   * @param values receives one number per input.
   * @param instance index of the instance; 0 for meshes without instances.
   * @param engine object that draws the frame, e.g. a renderer; null if nothing is drawn.
   */
  read(values: Float64Array, instance: number, engine: Engine | null): void
}

/** Kinds of inputs that are read from an engine. Inputs of the kind `value` are set by the application. */
export type MeasuredKind = Exclude<ExternalInputKind, 'value'>

/** One reader for each kind of input that a plan uses. */
export type InputReaders<Engine> = { readonly [K in MeasuredKind]?: InputReader<Engine> }

/** Creates readers that read the inputs of a plan from a mesh. A plan is the compiled form of a list of drivers. */
export type BindInputs<Engine> = (inputs: DriverPlan['inputs']) => InputReaders<Engine>

const MEASURED = ['target', 'joint', 'tension'] as const satisfies readonly MeasuredKind[]

/** Value in `#indices` for an area that the face does not have. */
const NO_AREA = 0xffff

/**
 * Runs drivers on the faces of one mesh. Drivers compute activations of areas from inputs such as blendshape weights. A frame calls
 * `readInputs`, `evaluate` and `apply` in this order. Nothing is allocated after the first frame. Faces with unchanged inputs and
 * activations are skipped.
 */
export class DriverRuntime<Engine> {
  readonly plan: DriverPlan
  readonly #bindInputs: BindInputs<Engine>
  readonly #values: InputSource
  /** Inputs that the application sets: one array per input, with one value per face. */
  readonly #named: readonly Float64Array[]
  readonly #label: string
  /** Whether a driver has a delay, so that activations depend on time. */
  readonly #isDelayed: boolean
  /** One array per face, with one activation per area of the plan. All arrays are views of one buffer. */
  readonly #activations: readonly Float32Array[]
  /** Time of the last frame of each face, in milliseconds. */
  readonly #times: Float64Array
  /** For each area of the plan, the index of this area in the face, or `NO_AREA`. */
  readonly #indices: Uint16Array
  /** Value of `Face.slots` when `#indices` was computed. If the face has another value, its areas have changed. */
  #slots: Face['slots'] | null = null
  #bound: Bound<Engine> | null = null

  /**
   * @param bindInputs is called in the first frame, or by `bind`.
   * @param inputs inputs that the application sets.
   * @param label name of the mesh in warnings.
   */
  constructor(
    plan: DriverPlan,
    bindInputs: BindInputs<Engine>,
    inputs: NamedInputs,
    faces: number,
    label: string,
  ) {
    this.plan = plan
    this.#bindInputs = bindInputs
    this.#label = label
    this.#isDelayed = plan.activationFilters.length > 0
    const areas = plan.areaNames.length
    const activations = new Float32Array(faces * areas)
    this.#activations = Array.from({ length: faces }, (_, i) =>
      activations.subarray(i * areas, (i + 1) * areas),
    )
    this.#times = new Float64Array(faces)
    this.#indices = new Uint16Array(areas)
    const values = valueSource(plan.inputs.value)
    this.#values = values
    // Inputs are declared now, so that the application can read their initial values before the first frame.
    this.#named = values.names.map((name, i) => inputs.declare(name, values.initial[i]))
  }

  /** Binds the inputs on the first call, and warns of inputs that the mesh lacks. */
  bind(): void {
    // `#findInputs` is a separate method, because its closures would allocate in every frame if they were here.
    this.#bound ??= this.#findInputs()
  }

  #findInputs(): Bound<Engine> {
    const { plan } = this
    const readers = this.#bindInputs(plan.inputs)
    const program = new DriverProgram(plan, { ...readers, value: this.#values })
    const state = program.createState()
    this.#warn([
      ...plan.unknownTypes.map((type) => `driver of type "${type}"`),
      ...program.missing,
      ...plan.cyclicAreas.map((area) => `area "${area}" (cyclic)`),
    ])
    const faces = this.#times.length
    return {
      program,
      state,
      delayed: this.#isDelayed ? Array.from({ length: faces }, () => program.createState()) : [],
      last: new LastInputs(faces, state.values.length),
      readers: MEASURED.flatMap((kind) => {
        const reader = readers[kind]
        return reader && plan.inputs[kind].length > 0 ? { reader, values: state.inputs[kind] } : []
      }),
    }
  }

  readInputs(faces: readonly Face[], clock: { now(): number }, engine: Engine | null): void {
    this.bind()
    const { state, delayed, readers, last } = this.#bound!
    const named = this.#named
    for (let i = 0; i < faces.length; i++) {
      for (let k = 0; k < readers.length; k++) readers[k].reader.read(readers[k].values, i, engine)
      for (let k = 0; k < named.length; k++) state.inputs.value[k] = named[k][i]
      last.take(i, state.values)
    }
    if (!this.#isDelayed) return
    const now = clock.now()
    for (let i = 0; i < faces.length; i++) {
      delayed[i].seconds[0] = (now - this.#times[i]) / 1000
      this.#times[i] = now
    }
  }

  evaluate(faces: readonly Face[]): void {
    if (faces[0].slots !== this.#slots) this.#findAreas(faces[0])
    this.bind()
    const { program, state, delayed, last } = this.#bound!
    for (let i = 0; i < faces.length; i++) {
      const isUnchanged = !last.check(i, faces[i]) && (!this.#isDelayed || delayed[i].isSettled)
      if (isUnchanged) continue
      last.isDue[i] = 1
      const activations = this.#activations[i]
      if (this.#isDelayed) {
        last.get(i, delayed[i].values)
        this.#rest(faces[i], delayed[i].resting)
        program.evaluate(delayed[i])
        activations.set(delayed[i].activations)
      } else {
        last.get(i, state.values)
        this.#rest(faces[i], activations)
        program.addTo(activations, state.values)
      }
    }
  }

  /**
   * Copies the resting activations of a face into `values`, in the order of the plan's areas. Drivers then add to these values. Areas that the
   * face does not have get 0.
   */
  #rest({ resting: { values: from } }: Face, values: Float32Array): void {
    const indices = this.#indices
    for (let k = 0; k < indices.length; k++) values[k] = indices[k] === NO_AREA ? 0 : from[indices[k]]
  }

  /** Sets the activations of all faces to the results of the drivers. */
  apply(faces: readonly Face[]): void {
    this.bind()
    const { last } = this.#bound!
    const indices = this.#indices
    for (let i = 0; i < faces.length; i++) {
      if (!last.isDue[i]) continue
      const { activations } = faces[i]
      const values = this.#activations[i]
      for (let k = 0; k < indices.length; k++) {
        if (indices[k] !== NO_AREA) activations.setAt(indices[k], values, k)
      }
      last.settle(i, faces[i])
    }
  }

  /** Computes `#indices`, and warns of missing areas. */
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

  /** Returns, by area name, how much each driver adds to the activation. Uses the inputs of the last frame and ignores delays. Allocates. */
  explain(face: Face, instance: number): Map<string, DriverPart[]> {
    if (face.slots !== this.#slots) this.#findAreas(face)
    this.bind()
    const { program, last } = this.#bound!
    const state = program.createState()
    last.get(instance, state.values)
    this.#rest(face, state.resting)
    program.evaluate(state)
    return partsByArea(program, state)
  }

  #warn(missing: readonly string[]): void {
    if (missing.length === 0) return
    console.warn(
      formatProblem({
        who: 'Wrinkles',
        problem: `drivers of mesh "${this.#label}" reference missing inputs, areas or types`,
        value: missing.join(', '),
        remedy: 'the other drivers work',
      }),
    )
  }
}

interface Bound<Engine> {
  program: DriverProgram
  /** Scratch state, reused for each face. */
  state: DriverState
  /** One state per face if a driver has a delay; otherwise empty. */
  delayed: readonly DriverState[]
  last: LastInputs
  /** Readers, and for each reader the part of the scratch state that it fills. */
  readers: readonly { reader: InputReader<Engine>; values: Float64Array }[]
}
