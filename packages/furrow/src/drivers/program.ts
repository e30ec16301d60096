import { type ExternalInputKind, type Input, inputName } from './activation.ts'
import { ActivationSum, type BoundActivation, type BoundLink } from './activation-sum.ts'
import { type Contribution, contributionOf } from './contribution.ts'
import { pointsOf } from './curve.ts'
import type { ActivationFilter } from './definition.ts'
import type { DriverPlan, PlannedActivation } from './plan.ts'

/** An input of drivers, resolved to values of a source. */
export interface BoundInput {
  /** Indices of values of the source. The input is the mean of these values. Empty if the model lacks the input. */
  indices: readonly number[]
  /** Parts that the model lacks, as text for warnings, e.g. `target "jawOpen"`. */
  missing: readonly string[]
}

/** Describes the values from which the inputs of one kind, such as blendshape weights, are read. */
export interface InputSource {
  /** Number of values per face. */
  readonly count: number
  /** The plan's inputs of this kind, in the plan's order. */
  readonly inputs: readonly BoundInput[]
}

/** One source per kind of input. Drivers that read inputs of a kind without a source are skipped. */
export type InputSources = { readonly [K in ExternalInputKind]?: InputSource }

/** Inputs and results of the drivers of one face, and state that drivers keep between frames. */
export interface DriverState {
  /** Values of all kinds of inputs. Input filters change them. */
  readonly values: Float64Array
  /** Values by kind of input, as views of `values`. The caller writes them before each call of `evaluate`. */
  readonly inputs: Readonly<Record<ExternalInputKind, Float64Array>>
  /** Resting activations, 0..1, of the plan's areas. The caller writes them. Drivers add to a copy of them. */
  readonly resting: Float32Array
  /** Resulting activations, 0..1, of the plan's areas. */
  readonly activations: Float32Array
  /** Filtered activations of the previous frame. Not updated for areas without an activation filter. */
  readonly previous: Float64Array
  /** One number: seconds since the previous frame. The caller writes it. */
  readonly seconds: Float64Array
  /** Whether a previous frame exists. */
  hasRun: boolean
  /** Whether activation filters have settled, so that the same inputs result in the same activations in the next frame. */
  isSettled: boolean
}

const KINDS = ['target', 'joint', 'tension', 'value'] as const satisfies readonly ExternalInputKind[]

/**
 * Evaluates the drivers of a plan on a model. Drivers compute activations of areas (groups of wrinkles) from inputs. The order of evaluation
 * is: input filters, drivers that read inputs, drivers that read areas, activation filters. `createState` creates the state of a face.
 */
export class DriverProgram {
  readonly plan: DriverPlan
  /** Missing inputs, e.g. `target "jawOpen" of a driver of area "chin"`. */
  readonly missing: readonly string[]
  /** Drivers of the plan that activate an area and whose inputs can be read, in evaluation order. */
  readonly activations: readonly PlannedActivation[]
  readonly #bound: readonly BoundActivation[]
  readonly #sum: ActivationSum
  readonly #inputFilters: readonly ((values: Float64Array) => void)[]
  readonly #activationFilters: readonly ReturnType<ActivationFilter['bind']>[]
  /** Scratch copy of the previous frame's activations. */
  readonly #before: Float64Array
  readonly #ranges: Readonly<Record<ExternalInputKind, { start: number; end: number }>>

  /** @param sources sources of the plan's inputs. */
  constructor(plan: DriverPlan, sources: InputSources) {
    const ranges = {} as Record<ExternalInputKind, { start: number; end: number }>
    const bound = new Map<Input, BoundInput>()
    let end = 0
    for (const kind of KINDS) {
      const source = sources[kind]
      const start = end
      end += source?.count ?? 0
      ranges[kind] = { start, end }
      for (const [i, { indices, missing }] of (source?.inputs ?? []).entries()) {
        bound.set(plan.inputs[kind][i], { indices: indices.map((index) => start + index), missing })
      }
    }
    for (const input of plan.inputs.area) {
      bound.set(input, { indices: [plan.areaNames.indexOf(input.name)], missing: [] })
    }
    this.plan = plan
    this.#ranges = ranges
    this.activations = plan.activations.filter(({ activation: { links } }) => {
      return links.every(({ input }) => canRead(input, bound.get(input)))
    })
    this.#bound = this.activations.map(({ activation }) => bind(activation, plan, bound))
    this.#sum = new ActivationSum(this.#bound)
    this.#inputFilters = plan.inputFilters
      .filter(({ filter }) => filter.inputs.every((input) => (bound.get(input)?.indices.length ?? 0) > 0))
      .map(({ filter }) =>
        filter.bind(filter.inputs.map((input) => Uint16Array.from(bound.get(input)!.indices))),
      )
    this.#activationFilters = plan.activationFilters.map((filter) =>
      filter.bind(plan.areaNames.indexOf(filter.area)),
    )
    this.#before = new Float64Array(plan.areaNames.length)
    this.missing = listMissing(plan, bound)
  }

  createState(): DriverState {
    const areas = this.plan.areaNames.length
    const values = new Float64Array(this.#ranges.value.end)
    const view = (kind: ExternalInputKind) =>
      values.subarray(this.#ranges[kind].start, this.#ranges[kind].end)
    return {
      values,
      inputs: {
        target: view('target'),
        joint: view('joint'),
        tension: view('tension'),
        value: view('value'),
      },
      resting: new Float32Array(areas),
      activations: new Float32Array(areas),
      previous: new Float64Array(areas),
      seconds: new Float64Array(1),
      hasRun: false,
      isSettled: false,
    }
  }

  /** Computes `activations` from this frame's `inputs`, `resting` and `seconds`. Allocates nothing. */
  evaluate(state: DriverState): void {
    state.activations.set(state.resting)
    this.addTo(state.activations, state.values)
    if (this.#activationFilters.length > 0) this.#filter(state)
    else state.isSettled = true
  }

  /**
   * Filters inputs, and adds the output of each driver to its area. Does not run activation filters. Allocates nothing.
   *
   * @param activations resting activations of the plan's areas; modified.
   * @param values values of all inputs; modified by input filters.
   */
  addTo(activations: Float32Array, values: Float64Array): void {
    for (let i = 0; i < this.#inputFilters.length; i++) this.#inputFilters[i](values)
    this.#sum.addTo(activations, values)
  }

  #filter(state: DriverState): void {
    const { activations, previous, seconds } = state
    if (!state.hasRun) previous.set(activations)
    state.hasRun = true
    this.#before.set(previous)
    for (let i = 0; i < this.#activationFilters.length; i++) {
      this.#activationFilters[i](activations, previous, seconds)
    }
    state.isSettled = seconds[0] > 0 && isSame(previous, this.#before)
  }

  /**
   * Returns the contribution of one driver to its area. Allocates.
   *
   * @param index index of the driver in `activations`.
   * @param state state after a call of `evaluate`.
   */
  explain(index: number, state: DriverState): Contribution {
    return contributionOf(this.#sum, index, this.#bound[index], state.activations, state.values)
  }
}

function isSame(a: Float64Array, b: Float64Array): boolean {
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false
  return true
}

/** Whether a driver can read an input. A blendshape that the model lacks has weight 0. Other inputs need at least one value. */
function canRead(input: Input, bound: BoundInput | undefined): boolean {
  return bound !== undefined && (input.kind === 'target' || bound.indices.length > 0)
}

function bind(
  { area, links, rule, curve }: PlannedActivation['activation'],
  { areaNames }: DriverPlan,
  bound: ReadonlyMap<Input, BoundInput>,
): BoundActivation {
  const boundLinks = links.map(
    ({ input, weight, curve }): BoundLink => ({
      name: inputName(input),
      indices: Uint16Array.from(bound.get(input)!.indices),
      isArea: input.kind === 'area',
      weight,
      points: curve && pointsOf(curve),
    }),
  )
  return { area: areaNames.indexOf(area), links: boundLinks, rule, points: pointsOf(curve) }
}

function listMissing(plan: DriverPlan, bound: ReadonlyMap<Input, BoundInput>): string[] {
  const missingOf = (input: Input) => bound.get(input)?.missing ?? []
  return [
    ...plan.activations.flatMap(({ activation: { area, links } }) =>
      links.flatMap(({ input }) => missingOf(input).map((part) => `${part} of a driver of area "${area}"`)),
    ),
    ...plan.inputFilters.flatMap(({ driver, filter }) =>
      filter.inputs.flatMap((input) =>
        missingOf(input).map((part) => `${part} of a driver of type "${driver.type}"`),
      ),
    ),
  ]
}
