import { FurrowError } from '../core/error.ts'
import type { Area, ArraySlice } from '../core/types.ts'
import type { Explanation } from '../drivers/explain.ts'
import type { Expression } from '../drivers/expression/expression.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import type { Clock, FaceGroup } from './face-group.ts'
import type { NamedInputs } from './named-inputs.ts'

const groups = new WeakMap<WrinkleFaces, FaceGroup<never>>()

/** Returns the internal faces of wrinkles, for code of the library. */
export function groupOf(wrinkles: WrinkleFaces): FaceGroup<never> {
  const group = groups.get(wrinkles)
  if (group) return group
  throw new FurrowError({
    who: 'Wrinkles',
    problem: 'the wrinkles were created by another copy of furrow',
    remedy: 'install one version of furrow, and import it from one place',
  })
}

/** Wrinkles of a mesh or of each of its instances, independent of the engine: areas, activations, inputs and drivers. */
export abstract class WrinkleFaces {
  protected constructor(group: FaceGroup<never>) {
    groups.set(this, group)
  }

  /** Whether drivers activate their areas. Set to false to activate areas yourself. */
  get driven(): boolean {
    return groupOf(this).driven
  }

  set driven(driven: boolean) {
    groupOf(this).driven = driven
  }

  /** Custom inputs of drivers, e.g. `inputs.set('age', 40)`. */
  get inputs(): NamedInputs {
    return groupOf(this).inputs
  }

  /** Clock for drivers with a delay. Replace it if frames are not drawn in real time. */
  get clock(): Clock {
    return groupOf(this).clock
  }

  /** @throws FurrowError if the clock has no method `now`. */
  set clock(clock: Clock) {
    groupOf(this).clock = clock
  }

  /** Whether `dispose` was called. Setters then throw. */
  get isDisposed(): boolean {
    return groupOf(this).isDisposed
  }

  /** Number of faces: the number of instances, or 1 for meshes without instances. */
  get faceCount(): number {
    return groupOf(this).faces.length
  }

  /** Area names in the order of the activations. */
  get areaNames(): string[] {
    return groupOf(this).areaNames
  }

  /** Returns the area with the name; undefined if there is none. */
  getArea(name: string): Area<ArraySlice> | undefined {
    return groupOf(this).getArea(name)
  }

  /** Whether an area with the name exists. */
  hasArea(name: string): boolean {
    return groupOf(this).hasArea(name)
  }

  /**
   * Sets the activation of an area. On areas driven by motion (`isDriven`), the value lasts until the next frame. On others it stays, and
   * custom inputs such as age add to it.
   *
   * @param value 0..1; clamped, with one warning.
   * @param instance index of an instance; default 0.
   * @throws FurrowError if the area is unknown, the value is not a number, the instance does not exist, or the wrinkles have been disposed.
   */
  setActivation(area: string, value: number, instance = 0): void {
    groupOf(this).setActivation(area, value, instance)
  }

  /**
   * Sets the activations of several areas, as `setActivation` does. Ignores unknown names, and allocates nothing.
   *
   * @param values 0..1, in the order of the names; clamped.
   * @param instance index of an instance; default 0.
   * @throws FurrowError if there are fewer values than names, the instance does not exist, or the wrinkles have been disposed.
   */
  setActivations(names: readonly string[], values: Float32Array, instance = 0): void {
    groupOf(this).setActivations(names, values, instance)
  }

  /**
   * Returns the activation of an area, 0..1, from the last frame or `setActivation`.
   *
   * @throws FurrowError if the area is unknown or the instance does not exist.
   */
  getActivation(area: string, instance = 0): number {
    return groupOf(this).getActivation(area, instance)
  }

  /**
   * Sets the resting activation of an area, to which drivers add. Animations in files set it too.
   *
   * @param value 0..1; clamped, with one warning.
   * @throws FurrowError if the area is unknown, the value is not a number, the instance does not exist, or the wrinkles have been disposed.
   */
  setRestingActivation(area: string, value: number, instance = 0): void {
    groupOf(this).setRestingActivation(area, value, instance)
  }

  /**
   * Returns the resting activation of an area, 0..1.
   *
   * @throws FurrowError if the area is unknown or the instance does not exist.
   */
  getRestingActivation(area: string, instance = 0): number {
    return groupOf(this).getRestingActivation(area, instance)
  }

  /**
   * Whether blendshapes, joints, tension or other areas currently drive an area, so that `setActivation` lasts only until the next frame.
   * False for unknown names.
   */
  isDriven(area: string): boolean {
    return groupOf(this).isDriven(area)
  }

  /**
   * Explains the activation of each area, as of the last frame: how much each driver adds, and how much each of its inputs. For panels and
   * debugging; it allocates.
   *
   * @param instance index of an instance, 0 by default.
   * @returns one explanation per area, in the order of `areaNames`; without parts while `driven` is false.
   * @throws FurrowError when there is no such instance, or the wrinkles were disposed of.
   */
  explain(instance = 0): Explanation[] {
    return groupOf(this).explain(instance)
  }

  /** Active drivers in the order in which they were added, see `addDrivers` and `setDrivers`. */
  get drivers(): readonly WrinkleDriver[] {
    return groupOf(this).drivers
  }

  /** Expressions of the file: expression drivers, then expressions of a VRM. */
  get expressions(): readonly Expression[] {
    return groupOf(this).expressions
  }

  /** Registers a function that `dispose` calls. */
  onDispose(dispose: () => void): void {
    groupOf(this).onDispose(dispose)
  }

  /** Restores the material, and frees resources that no other face uses. */
  dispose(): void {
    groupOf(this).dispose()
  }
}
