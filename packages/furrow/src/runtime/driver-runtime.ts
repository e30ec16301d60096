import { formatProblem } from '../core/error.ts'
import type { ExternalInputKind } from '../drivers/activation.ts'
import { type DriverPart, partsByArea } from '../drivers/explain.ts'
import type { DriverPlan } from '../drivers/plan.ts'
import { DriverProgram, type DriverState, type InputSource } from '../drivers/program.ts'
import { valueSource } from '../drivers/sources.ts'
import type { Face } from './face.ts'
import { LastInputs } from './last-inputs.ts'
import type { NamedInputs } from './named-inputs.ts'

/** Reads the inputs of one kind from an engine's objects. */
export interface InputReader<Engine> extends InputSource {
  /**
   * Reads the inputs of one face. Runs per frame and should not allocate.
   *
   * @param values receives `count` numbers.
   * @param instance index of the instance; 0 for meshes without instances.
   * @param engine object that draws the frame, e.g. a renderer; null if nothing is drawn.
   */
  read(values: Float64Array, instance: number, engine: Engine | null): void
}

/** Kinds of inputs that an engine measures. */
export type MeasuredKind = Exclude<ExternalInputKind, 'value'>

/** Reader of each kind that a plan uses. */
export type InputReaders<Engine> = { readonly [K in MeasuredKind]?: InputReader<Engine> }

/** Binds the inputs of a plan to a mesh. */
export type BindInputs<Engine> = (inputs: DriverPlan['inputs']) => InputReaders<Engine>

const MEASURED = ['target', 'joint', 'tension'] as const satisfies readonly MeasuredKind[]

/** Index of an area that the face does not have. */
const NO_AREA = 0xffff

/**
 * Runs drivers on the faces of one mesh, with one method per phase of a frame. Allocates nothing after the first frame. Faces with
 * unchanged inputs and activations are skipped.
 */
export class DriverRuntime<Engine> {
  readonly plan: DriverPlan
  readonly #bindInputs: BindInputs<Engine>
  readonly #values: InputSource
  /** Values of the inputs that the application sets: one array per input, with one value per face. */
  readonly #named: readonly Float64Array[]
  readonly #label: string
  /** Whether activations depend on time. */
  readonly #isDelayed: boolean
  /** One array per face, with one activation per area of the plan. All are views of one buffer. */
  readonly #activations: readonly Float32Array[]
  /** Time of the last frame of each face, milliseconds. */
  readonly #times: Float64Array
  /** Index of the face's area for each area of the plan, or `NO_AREA`. */
  readonly #indices: Uint16Array
  /** Areas of the face for which `#indices` was computed. */
  #slots: Face['slots'] | null = null
  #bound: Bound<Engine> | null = null

  /**
   * @param bindInputs called in the first frame, or by `bind`.
   * @param inputs numbers set by the application.
   * @param faces number of faces.
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
    // Declared now, so that the application can read initial values before the first frame.
    this.#named = values.names.map((name, i) => inputs.declare(name, values.initial[i]))
  }

  /** Binds the inputs once, and warns of inputs that the mesh lacks. */
  bind(): void {
    // Separate method: closures here would allocate every frame.
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

  /** Phase 1: reads the inputs of all faces. */
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

  /** Phase 2: evaluates the drivers of all faces. */
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

  /** Writes the resting activations of a face, by area of the plan. */
  #rest({ resting: { values: from } }: Face, values: Float32Array): void {
    const indices = this.#indices
    for (let k = 0; k < indices.length; k++) values[k] = indices[k] === NO_AREA ? 0 : from[indices[k]]
  }

  /** Phase 3: sets the faces' activations. */
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

  /** Resolves the areas, which may have been added or removed, and warns of missing ones. */
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

  /** Lists what each driver adds to its area for one face, from the inputs of the last frame and without delays. Allocates. */
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
  /** Scratch, reused per face. */
  state: DriverState
  /** State of each face if activations depend on time; otherwise empty. */
  delayed: readonly DriverState[]
  last: LastInputs
  /** Readers, each with the view of the scratch state that it writes. */
  readers: readonly { reader: InputReader<Engine>; values: Float64Array }[]
}
