import { FurrowError } from '../core/error.ts'
import type { Area, ArraySlice } from '../core/types.ts'
import type { Explanation } from '../drivers/explain.ts'
import type { Expression } from '../drivers/expression/expression.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import type { Clock, FaceGroup } from './face-group.ts'
import type { NamedInputs } from './named-inputs.ts'

const groups = new WeakMap<WrinkleFaces, FaceGroup<never>>()

/** Returns the internal state of wrinkles, for code in this library. */
export function groupOf(wrinkles: WrinkleFaces): FaceGroup<never> {
  const group = groups.get(wrinkles)
  if (group) return group
  throw new FurrowError({
    who: 'Wrinkles',
    problem: 'the wrinkles were created by another copy of furrow',
    remedy: 'install one version of furrow, and import it from one place',
  })
}

/** Wrinkles of one mesh or of each of its instances: areas, activations, inputs and drivers. Base class for `Wrinkles` of each engine. */
export abstract class WrinkleFaces {
  protected constructor(group: FaceGroup<never>) {
    groups.set(this, group)
  }

  /** Whether drivers run. Set this to false to set all activations yourself. */
  get driven(): boolean {
    return groupOf(this).driven
  }

  set driven(driven: boolean) {
    groupOf(this).driven = driven
  }

  /** Inputs that the application sets for drivers, e.g. `inputs.set('age', 40)`. */
  get inputs(): NamedInputs {
    return groupOf(this).inputs
  }

  /** Clock that drivers with a delay use. Replace it if frames are not drawn in real time. */
  get clock(): Clock {
    return groupOf(this).clock
  }

  /** @throws FurrowError if the clock has no method `now`. */
  set clock(clock: Clock) {
    groupOf(this).clock = clock
  }

  /** Whether `dispose` was called. Afterwards, methods that change the wrinkles throw. */
  get isDisposed(): boolean {
    return groupOf(this).isDisposed
  }

  /** Number of instances, or 1 for meshes without instances. */
  get faceCount(): number {
    return groupOf(this).faces.length
  }

  /** Names of the areas, in the order of the wrinkle set. Added areas come last. */
  get areaNames(): string[] {
    return groupOf(this).areaNames
  }

  /** Returns the area with the name, or undefined if there is none. */
  getArea(name: string): Area<ArraySlice> | undefined {
    return groupOf(this).getArea(name)
  }

  /** Whether an area with the name exists. */
  hasArea(name: string): boolean {
    return groupOf(this).hasArea(name)
  }

  /**
   * Sets the activation of an area. If blendshapes, joints, tension or other areas drive the area, the value lasts until the drivers run again.
   * Otherwise the value becomes the resting activation, to which inputs such as age add.
   *
   * @param value 0..1. Other values are clamped, with one warning.
   * @param instance index of an instance; default 0.
   * @throws FurrowError if the area is unknown, `value` is not of type number, the instance does not exist, or the wrinkles have been disposed.
   */
  setActivation(area: string, value: number, instance = 0): void {
    groupOf(this).setActivation(area, value, instance)
  }

  /**
   * Sets the activations of several areas, as `setActivation` does. Ignores unknown names. Allocates nothing.
   *
   * @param values activations in the order of the names. Values outside 0..1 are clamped.
   * @param instance index of an instance; default 0.
   * @throws FurrowError if there are fewer values than names, the instance does not exist, or the wrinkles have been disposed.
   */
  setActivations(names: readonly string[], values: Float32Array, instance = 0): void {
    groupOf(this).setActivations(names, values, instance)
  }

  /**
   * Returns the current activation of an area, 0..1.
   *
   * @throws FurrowError if the area is unknown or the instance does not exist.
   */
  getActivation(area: string, instance = 0): number {
    return groupOf(this).getActivation(area, instance)
  }

  /**
   * Sets the resting activation of an area. Drivers add to this activation. Animations in glTF files set it too.
   *
   * @param value 0..1. Other values are clamped, with one warning.
   * @throws FurrowError if the area is unknown, `value` is not of type number, the instance does not exist, or the wrinkles have been disposed.
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
   * Whether blendshapes, joints, tension or other areas drive an area. If so, values of `setActivation` last until the next frame. Returns
   * false for unknown names and while `driven` is false.
   */
  isDriven(area: string): boolean {
    return groupOf(this).isDriven(area)
  }

  /**
   * Explains the activation of each area in the last frame: how much each driver added, and how much each input of the driver
   * contributed. For inspector panels and debugging. Allocates.
   *
   * @param instance index of an instance; default 0.
   * @returns one explanation per area, in the order of `areaNames`. `parts` is empty while `driven` is false.
   * @throws FurrowError if the instance does not exist, or the wrinkles have been disposed.
   */
  explain(instance = 0): Explanation[] {
    return groupOf(this).explain(instance)
  }

  /** Drivers in the order in which `addDrivers` or `setDrivers` received them. */
  get drivers(): readonly WrinkleDriver[] {
    return groupOf(this).drivers
  }

  /** Facial expressions in the file: first those of expression drivers, then those of a VRM avatar. */
  get expressions(): readonly Expression[] {
    return groupOf(this).expressions
  }

  /** Registers a function that `dispose` will call. */
  onDispose(dispose: () => void): void {
    groupOf(this).onDispose(dispose)
  }

  /** Removes the wrinkles: restores the material, and frees resources that no other face uses. */
  dispose(): void {
    groupOf(this).dispose()
  }
}
