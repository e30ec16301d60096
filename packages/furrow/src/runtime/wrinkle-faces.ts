import { wrongArgument } from '../core/argument.ts'
import { FurrowError } from '../core/error.ts'
import type { Area, ArraySlice } from '../core/types.ts'
import { type Expression, expressionsOf } from '../drivers/expression/expression.ts'
import type { DriverPlan } from '../drivers/plan.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import type { AreaSlots } from './area-slots.ts'
import { type BindInputs, DriverRuntime } from './driver-runtime.ts'
import { Face } from './face.ts'
import { checkInstance, NamedInputs } from './named-inputs.ts'

/** A source of time. */
export interface Clock {
  /** Milliseconds since any fixed moment. */
  now(): number
}

/**
 * The wrinkles of a mesh, or of each of its instances, independent of the engine: areas, activations, inputs and drivers.
 *
 * @typeParam Engine what draws a frame, e.g. a renderer.
 */
export abstract class WrinkleFaces<Engine = unknown> {
  /** Whether drivers activate their areas; set it to false to activate them yourself. */
  driven = true
  /** The mesh that drives. */
  abstract readonly mesh: { readonly name: string }
  /** Numbers that the application sets for drivers: `inputs.set('age', 40)`. */
  readonly inputs: NamedInputs

  /** One per instance. */
  protected readonly faces: readonly Face[]
  /** In the order of the activations. */
  protected areas: Area<ArraySlice>[]
  #clock: Clock = performance
  #isDisposed = false
  #runtime: DriverRuntime<Engine> | null = null
  #expressions: readonly Expression[] = []
  readonly #disposers: (() => void)[] = []

  /**
   * @param count number of faces.
   * @param slots of the areas, in their order.
   */
  constructor(count: number, areas: readonly Area<ArraySlice>[], slots: AreaSlots) {
    this.areas = [...areas]
    this.faces = Array.from({ length: count }, () => new Face(slots, areas))
    this.inputs = new NamedInputs(count, (method) => this.checkInUse(method))
  }

  /** The time for drivers with a delay; replace it if frames are not drawn in real time. */
  get clock(): Clock {
    return this.#clock
  }

  /** @throws FurrowError when it cannot tell the time. */
  set clock(clock: Clock) {
    if (typeof clock?.now !== 'function') {
      throw wrongArgument('Wrinkles.clock', 'a clock', clock, 'an object with now()')
    }
    this.#clock = clock
  }

  /** Whether `dispose` was called: setters then throw. */
  get isDisposed(): boolean {
    return this.#isDisposed
  }

  /** Names of the areas, in the order of the activations. */
  get areaNames(): string[] {
    return this.areas.map(({ name }) => name)
  }

  /** The area of that name, as it was given; undefined if there is none. */
  getArea(name: string): Area<ArraySlice> | undefined {
    return this.areas.find((area) => area.name === name)
  }

  /** Whether an area of that name exists. */
  hasArea(name: string): boolean {
    return this.faces[0].activations.has(name)
  }

  /**
   * Activates an area. If the face's motion drives it (`isDriven`), this lasts until the next frame; otherwise it stays, and the
   * application's inputs, such as age, add to it.
   *
   * @param value 0..1; clamped, with one warning.
   * @param instance index of an instance, 0 by default.
   * @throws FurrowError when no area has that name, the value is not a number, there is no such instance, or the wrinkles were disposed of.
   */
  setActivation(area: string, value: number, instance = 0): void {
    this.checkInUse('setActivation')
    const face = this.#faceOf(instance, 'setActivation')
    if (this.#isMoved(area)) face.activations.set(area, value)
    else face.setResting(area, value)
  }

  /**
   * Activates several areas, as `setActivation` does, but ignores names that no area has, and allocates nothing.
   *
   * @param values 0..1, in the order of the names; clamped.
   * @param instance index of an instance, 0 by default.
   * @throws FurrowError when there are fewer values than names, no such instance, or the wrinkles were disposed of.
   */
  setActivations(names: readonly string[], values: Float32Array, instance = 0): void {
    this.checkInUse('setActivations')
    if (!Array.isArray(names) || !(values?.length >= names.length)) {
      throw wrongArgument(
        'Wrinkles.setActivations',
        'values',
        values?.length,
        `one for each of ${names?.length} names`,
      )
    }
    const { activations, resting } = this.#faceOf(instance, 'setActivations')
    activations.setNamed(names, values)
    resting.setNamed(names, values, this.plan?.movedAreas)
  }

  /**
   * The activation of an area, 0..1, as of the last frame or `setActivation`.
   *
   * @throws FurrowError when no area has that name.
   */
  getActivation(area: string, instance = 0): number {
    return this.#faceOf(instance, 'getActivation').activations.get(area)
  }

  /**
   * Sets an area's activation at rest, to which drivers add. Animations of a file do this.
   *
   * @param value 0..1; clamped, with one warning.
   * @throws FurrowError when no area has that name, the value is not a number, there is no such instance, or the wrinkles were disposed of.
   */
  setRestingActivation(area: string, value: number, instance = 0): void {
    this.checkInUse('setRestingActivation')
    this.#faceOf(instance, 'setRestingActivation').setResting(area, value)
  }

  /**
   * The activation of an area at rest, 0..1.
   *
   * @throws FurrowError when no area has that name.
   */
  getRestingActivation(area: string, instance = 0): number {
    return this.#faceOf(instance, 'getRestingActivation').resting.get(area)
  }

  /**
   * Whether blendshapes, joints, tension or other areas drive an area now, so that `setActivation` lasts until the next frame only.
   * False for names that no area has.
   */
  isDriven(area: string): boolean {
    return this.driven && this.#isMoved(area)
  }

  /** The drivers in force, in the order in which they were added; see `addDrivers` and `setDrivers`. */
  get drivers(): readonly WrinkleDriver[] {
    return this.plan?.drivers ?? []
  }

  /** Preset expressions among the drivers. */
  get expressions(): readonly Expression[] {
    return this.#expressions
  }

  /** The plan of the drivers. @internal */
  get plan(): DriverPlan | undefined {
    return this.#runtime?.plan
  }

  /**
   * Replaces the drivers.
   *
   * @param bindInputs finds their inputs on the mesh.
   * @param isLate whether inputs are found at the first frame; otherwise now.
   */
  protected driveBy(plan: DriverPlan, bindInputs: BindInputs<Engine>, isLate: boolean): void {
    const runtime = new DriverRuntime(plan, bindInputs, this.inputs, this.faces.length, this.mesh.name)
    if (!isLate) runtime.bind()
    this.#runtime = runtime
    this.#expressions = expressionsOf(plan.drivers)
  }

  /** Phase 1 of a frame, see `Frame`. @internal */
  readInputs(engine: Engine | null): void {
    if (this.driven) this.#runtime?.readInputs(this.faces, this.clock, engine)
  }

  /** Phase 2. @internal */
  evaluateDrivers(): void {
    if (this.driven) this.#runtime?.evaluate(this.faces)
  }

  /** Phase 3. @internal */
  applyActivations(): void {
    if (this.driven) this.#runtime?.apply(this.faces)
  }

  /** Registers a function to be called by `dispose`. */
  onDispose(dispose: () => void): void {
    if (typeof dispose !== 'function') {
      throw wrongArgument('Wrinkles.onDispose', 'what to call', dispose, 'a function')
    }
    this.#disposers.push(dispose)
  }

  /** Calls the functions registered by `onDispose`, and drops the drivers. */
  dispose(): void {
    this.#isDisposed = true
    for (const dispose of this.#disposers.splice(0)) dispose()
    this.#runtime = null
  }

  /** @throws FurrowError when the wrinkles were disposed of. */
  protected checkInUse(method: string): void {
    if (!this.#isDisposed) return
    throw new FurrowError({
      who: `Wrinkles.${method}`,
      what: 'the wrinkles were disposed of',
      remedy: 'create new ones for the mesh',
    })
  }

  #faceOf(instance: number, method: string): Face {
    const face = this.faces[instance]
    if (!face) checkInstance(instance, this.faces.length, `Wrinkles.${method}`)
    return face
  }

  #isMoved(area: string): boolean {
    return this.plan?.movedAreas.has(area) ?? false
  }
}
