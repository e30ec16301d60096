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

/** Source of the current time. */
export interface Clock {
  /** Returns the milliseconds since a fixed moment. */
  now(): number
}

/**
 * Wrinkle state of one mesh, independent of the engine. A mesh with instances has one face per instance; other meshes have one face.
 * `WrinkleFaces` is the public interface of this class, and documents the methods and their errors.
 *
 * @typeParam Engine object that draws a frame, e.g. a renderer.
 */
export abstract class FaceGroup<Engine = unknown> {
  /** Whether drivers run. */
  driven = true
  /** Mesh whose blendshapes, joints and tension are inputs of drivers. */
  abstract readonly mesh: { readonly name: string }
  readonly inputs: NamedInputs
  readonly faces: readonly Face[]
  /** Areas in the order of the activations. */
  areas: Area<ArraySlice>[]
  #clock: Clock = performance
  #isDisposed = false
  #runtime: DriverRuntime<Engine> | null = null
  #expressions: readonly Expression[] = []
  /** Expressions of a VRM avatar, converted to blendshape weights. */
  protected vrmExpressions: readonly Expression[] = []
  readonly #disposers: (() => void)[] = []
  readonly #releasers: (() => void)[] = []

  /**
   * @param count number of faces.
   * @param slots slices and channels of the texture array that store the weights of areas, in the order of `areas`.
   */
  constructor(count: number, areas: readonly Area<ArraySlice>[], slots: AreaSlots) {
    this.areas = [...areas]
    this.faces = Array.from({ length: count }, () => new Face(slots, areas))
    this.inputs = new NamedInputs(count, (method) => this.checkInUse(method))
  }

  get clock(): Clock {
    return this.#clock
  }

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

  setActivation(area: string, value: number, instance = 0): void {
    this.checkInUse('setActivation')
    const face = this.#faceOf(instance, 'setActivation')
    if (this.#isMoved(area)) face.activations.set(area, value)
    else face.setResting(area, value)
  }

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

  getActivation(area: string, instance = 0): number {
    return this.#faceOf(instance, 'getActivation').activations.get(area)
  }

  setRestingActivation(area: string, value: number, instance = 0): void {
    this.checkInUse('setRestingActivation')
    this.#faceOf(instance, 'setRestingActivation').setResting(area, value)
  }

  getRestingActivation(area: string, instance = 0): number {
    return this.#faceOf(instance, 'getRestingActivation').resting.get(area)
  }

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
   * @param plan compiled drivers.
   * @param bindInputs creates readers for the inputs of the plan.
   * @param isLazy whether to bind inputs in the next frame instead of now.
   */
  setPlan(plan: DriverPlan, bindInputs: BindInputs<Engine>, isLazy: boolean): void {
    const runtime = new DriverRuntime(plan, bindInputs, this.inputs, this.faces.length, this.mesh.name)
    const { length } = this.#releasers
    if (!isLazy) runtime.bind()
    for (const release of this.#releasers.splice(0, length)) release()
    this.#runtime = runtime
    this.#expressions = expressionsOf(plan.drivers)
  }

  /** Reads the inputs of drivers: phase 1 of a frame. `Frame` documents the phases. */
  readInputs(engine: Engine | null): void {
    if (this.driven) this.#runtime?.readInputs(this.faces, this.clock, engine)
  }

  /** Evaluates the drivers: phase 2 of a frame. */
  evaluateDrivers(): void {
    if (this.driven) this.#runtime?.evaluate(this.faces)
  }

  /** Sets the activations: phase 3 of a frame. */
  applyActivations(): void {
    if (this.driven) this.#runtime?.apply(this.faces)
  }

  onDispose(dispose: () => void): void {
    if (typeof dispose !== 'function') {
      throw wrongArgument('Wrinkles.onDispose', 'callback', dispose, 'a function')
    }
    this.#disposers.push(dispose)
  }

  /** Registers a function that frees the GPU objects that read inputs. The next frame creates these objects again. */
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
