import { wrongArgument } from '../core/argument.ts'
import { FurrowError } from '../core/error.ts'
import type { Area, ArraySlice } from '../core/types.ts'
import type { Explanation } from '../drivers/explain.ts'
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
 * Faces of one mesh: one per instance, or the mesh itself. Holds areas, activations, inputs and drivers, independent of the engine.
 * `WrinkleFaces` is its public interface.
 *
 * @typeParam Engine object that draws a frame, e.g. a renderer.
 */
export abstract class FaceGroup<Engine = unknown> {
  /** Whether drivers activate their areas. */
  driven = true
  /** Mesh that supplies the inputs. */
  abstract readonly mesh: { readonly name: string }
  readonly inputs: NamedInputs
  readonly faces: readonly Face[]
  /** Areas in the order of the activations. */
  areas: Area<ArraySlice>[]
  #clock: Clock = performance
  #isDisposed = false
  #runtime: DriverRuntime<Engine> | null = null
  #expressions: readonly Expression[] = []
  /** Expressions of a VRM, as blendshapes. */
  protected vrmExpressions: readonly Expression[] = []
  readonly #disposers: (() => void)[] = []
  readonly #releasers: (() => void)[] = []

  /**
   * @param count number of faces.
   * @param slots slots of the areas, in the same order.
   */
  constructor(count: number, areas: readonly Area<ArraySlice>[], slots: AreaSlots) {
    this.areas = [...areas]
    this.faces = Array.from({ length: count }, () => new Face(slots, areas))
    this.inputs = new NamedInputs(count, (method) => this.checkInUse(method))
  }

  /** Clock for drivers with a delay. */
  get clock(): Clock {
    return this.#clock
  }

  /** @throws FurrowError if the clock has no method `now`. */
  set clock(clock: Clock) {
    if (typeof clock?.now !== 'function') {
      throw wrongArgument('Wrinkles.clock', 'clock', clock, 'an object with now()')
    }
    this.#clock = clock
  }

  get isDisposed(): boolean {
    return this.#isDisposed
  }

  get areaNames(): string[] {
    return this.areas.map(({ name }) => name)
  }

  getArea(name: string): Area<ArraySlice> | undefined {
    return this.areas.find((area) => area.name === name)
  }

  hasArea(name: string): boolean {
    return this.faces[0].activations.has(name)
  }

  /** @throws FurrowError if the area is unknown, the value is not a number, or the instance does not exist. */
  setActivation(area: string, value: number, instance = 0): void {
    this.checkInUse('setActivation')
    const face = this.#faceOf(instance, 'setActivation')
    if (this.#isMoved(area)) face.activations.set(area, value)
    else face.setResting(area, value)
  }

  /** @throws FurrowError if there are fewer values than names, or the instance does not exist. */
  setActivations(names: readonly string[], values: Float32Array, instance = 0): void {
    this.checkInUse('setActivations')
    if (!Array.isArray(names) || !(values?.length >= names.length)) {
      throw wrongArgument(
        'Wrinkles.setActivations',
        'number of values',
        values?.length,
        `at least ${names?.length}, one per name`,
      )
    }
    const { activations, resting } = this.#faceOf(instance, 'setActivations')
    activations.setNamed(names, values)
    resting.setNamed(names, values, this.plan?.movedAreas)
  }

  /** @throws FurrowError if the area is unknown or the instance does not exist. */
  getActivation(area: string, instance = 0): number {
    return this.#faceOf(instance, 'getActivation').activations.get(area)
  }

  /** @throws FurrowError if the area is unknown, the value is not a number, or the instance does not exist. */
  setRestingActivation(area: string, value: number, instance = 0): void {
    this.checkInUse('setRestingActivation')
    this.#faceOf(instance, 'setRestingActivation').setResting(area, value)
  }

  /** @throws FurrowError if the area is unknown or the instance does not exist. */
  getRestingActivation(area: string, instance = 0): number {
    return this.#faceOf(instance, 'getRestingActivation').resting.get(area)
  }

  /** @throws FurrowError when there is no such instance, or the wrinkles were disposed of. */
  explain(instance = 0): Explanation[] {
    this.checkInUse('explain')
    const face = this.#faceOf(instance, 'explain')
    const parts = this.driven ? this.#runtime?.explain(face, instance) : undefined
    return this.areaNames.map((area) => ({
      area,
      activation: face.activations.get(area),
      resting: face.resting.get(area),
      parts: parts?.get(area) ?? [],
    }))
  }

  isDriven(area: string): boolean {
    return this.driven && this.#isMoved(area)
  }

  get drivers(): readonly WrinkleDriver[] {
    return this.plan?.drivers ?? []
  }

  get expressions(): readonly Expression[] {
    return [...this.#expressions, ...this.vrmExpressions]
  }

  get plan(): DriverPlan | undefined {
    return this.#runtime?.plan
  }

  /**
   * Replaces the drivers.
   *
   * @param bindInputs binds the inputs to the mesh.
   * @param isLazy whether inputs are bound in the first frame instead of now.
   */
  setPlan(plan: DriverPlan, bindInputs: BindInputs<Engine>, isLazy: boolean): void {
    const runtime = new DriverRuntime(plan, bindInputs, this.inputs, this.faces.length, this.mesh.name)
    const { length } = this.#releasers
    if (!isLazy) runtime.bind()
    for (const release of this.#releasers.splice(0, length)) release()
    this.#runtime = runtime
    this.#expressions = expressionsOf(plan.drivers)
  }

  /** Phase 1 of a frame: reads inputs, see `Frame`. */
  readInputs(engine: Engine | null): void {
    if (this.driven) this.#runtime?.readInputs(this.faces, this.clock, engine)
  }

  /** Phase 2 of a frame. */
  evaluateDrivers(): void {
    if (this.driven) this.#runtime?.evaluate(this.faces)
  }

  /** Phase 3 of a frame. */
  applyActivations(): void {
    if (this.driven) this.#runtime?.apply(this.faces)
  }

  onDispose(dispose: () => void): void {
    if (typeof dispose !== 'function') {
      throw wrongArgument('Wrinkles.onDispose', 'callback', dispose, 'a function')
    }
    this.#disposers.push(dispose)
  }

  /** Registers a function that frees GPU objects of driver inputs. Reading the inputs later creates the objects again. */
  onRelease(release: () => void): void {
    this.#releasers.push(release)
  }

  /** Calls the functions registered by `onRelease`. */
  release(): void {
    for (const release of this.#releasers) release()
  }

  /** Calls the functions registered by `onRelease` and `onDispose`, and drops the drivers. */
  dispose(): void {
    this.#isDisposed = true
    this.release()
    for (const dispose of this.#disposers.splice(0)) dispose()
    this.#runtime = null
  }

  /** @throws FurrowError if the wrinkles have been disposed. */
  checkInUse(method: string): void {
    if (!this.#isDisposed) return
    throw new FurrowError({
      who: `Wrinkles.${method}`,
      problem: 'the wrinkles have been disposed',
      remedy: 'create new wrinkles for the mesh',
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
