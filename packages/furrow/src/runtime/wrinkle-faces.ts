import type { Area, ArraySlice } from '../core/types.ts'
import type { Expression } from '../drivers/expression/expression.ts'
import type { AreaSlots } from './area-slots.ts'
import type { DriverRuntime } from './driver-runtime.ts'
import { Face } from './face.ts'
import { NamedInputs } from './named-inputs.ts'

/**
 * The wrinkles of a mesh, or of each of its instances, as far as no engine is needed: areas, activations, inputs and drivers.
 *
 * @typeParam Engine what draws a frame, e.g. a renderer.
 */
export abstract class WrinkleFaces<Engine = unknown> {
  /** Whether the drivers of the file activate their areas; set it to false to activate them yourself. */
  driven = true
  /** Presets of the file. */
  expressions: readonly Expression[] = []
  /** Milliseconds, for drivers with a delay; replace it where frames are not drawn in real time. */
  clock: { now(): number } = performance
  /** What the application tells drivers: `inputs.set('age', 40)`. */
  readonly inputs: NamedInputs

  /** One per instance. */
  protected readonly faces: readonly Face[]
  protected areas: Area<ArraySlice>[]
  #drivers: DriverRuntime<Engine> | null = null
  readonly #disposers: (() => void)[] = []

  /**
   * @param count number of faces.
   * @param slots of the areas, in their order.
   */
  constructor(count: number, areas: readonly Area<ArraySlice>[], slots: AreaSlots) {
    this.areas = [...areas]
    this.faces = Array.from({ length: count }, () => new Face(slots, areas))
    this.inputs = new NamedInputs(count)
  }

  /** Names of the areas, in the order they are packed. */
  get areaNames(): string[] {
    return this.areas.map(({ name }) => name)
  }

  /** An area as it was given. */
  getArea(name: string): Area<ArraySlice> | undefined {
    return this.areas.find((area) => area.name === name)
  }

  /** Whether an area of that name exists. */
  hasArea(name: string): boolean {
    return this.faces[0].activations.has(name)
  }

  /**
   * Activates an area. On an area that blendshapes, joints and the like drive (`isDriven`), this lasts until the next frame;
   * on all others it stays, and what the application's inputs add, such as age, comes on top.
   *
   * @param value 0..1; clamped with one warning.
   * @param instance of an instanced mesh; 0 by default.
   * @throws FurrowError when no area has that name.
   */
  setActivation(area: string, value: number, instance = 0): void {
    const face = this.faces[instance]
    if (this.#isMoved(area)) face.activations.set(area, value)
    else face.rest(area, value)
  }

  /**
   * The same for many at once; names that no area has are ignored, and nothing is allocated.
   *
   * @param values 0..1, in the order of the names.
   */
  setActivations(names: readonly string[], values: Float32Array, instance = 0): void {
    const { activations, resting } = this.faces[instance]
    activations.setNamed(names, values)
    resting.setNamed(names, values, this.#drivers?.plan.movedAreas)
  }

  /** @throws FurrowError when no area has that name. */
  getActivation(area: string, instance = 0): number {
    return this.faces[instance].activations.get(area)
  }

  /**
   * Sets an area's activation at rest, to which drivers add. Key frames of a file do this.
   *
   * @param value 0..1; clamped with one warning.
   * @throws FurrowError when no area has that name.
   */
  setRestingActivation(area: string, value: number, instance = 0): void {
    this.faces[instance].rest(area, value)
  }

  /** @throws FurrowError when no area has that name. */
  getRestingActivation(area: string, instance = 0): number {
    return this.faces[instance].resting.get(area)
  }

  /** Whether blendshapes, joints or the like drive an area, so that `setActivation` lasts until the next frame only. */
  isDriven(area: string): boolean {
    return this.driven && this.#isMoved(area)
  }

  /** Sets what drives the areas, in place of what did before. */
  setDrivers(drivers: DriverRuntime<Engine>): void {
    this.#drivers = drivers
  }

  /** Phase 1 of a frame; see `Frame`. */
  readInputs(engine: Engine | null): void {
    if (this.driven) this.#drivers?.readInputs(this.faces, this.clock, engine)
  }

  /** Phase 2. */
  evaluateDrivers(): void {
    if (this.driven) this.#drivers?.evaluate(this.faces)
  }

  /** Phase 3. */
  applyActivations(): void {
    if (this.driven) this.#drivers?.apply(this.faces)
  }

  /** Calls a function when these wrinkles are disposed of. */
  onDispose(dispose: () => void): void {
    this.#disposers.push(dispose)
  }

  dispose(): void {
    for (const dispose of this.#disposers.splice(0)) dispose()
    this.#drivers = null
  }

  #isMoved(area: string): boolean {
    return this.#drivers?.plan.movedAreas.has(area) ?? false
  }
}
