import { FurrowError } from '../core/error.ts'
import type { Area, ArraySlice } from '../core/types.ts'
import type { Expression } from '../drivers/expression/expression.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import type { Clock, FaceGroup } from './face-group.ts'
import type { NamedInputs } from './named-inputs.ts'

const groups = new WeakMap<WrinkleFaces, FaceGroup<never>>()

/** The faces behind wrinkles, for code of the library. Users cannot reach them. */
export function groupOf(wrinkles: WrinkleFaces): FaceGroup<never> {
  const group = groups.get(wrinkles)
  if (group) return group
  throw new FurrowError({
    who: 'Wrinkles',
    problem: 'wrinkles that another copy of furrow made',
    remedy: 'install one version of furrow, and import it from one place',
  })
}

/** The wrinkles of a mesh, or of each of its instances, independent of the engine: areas, activations, inputs and drivers. */
export abstract class WrinkleFaces {
  protected constructor(group: FaceGroup<never>) {
    groups.set(this, group)
  }

  /** Whether drivers activate their areas; set it to false to activate them yourself. */
  get driven(): boolean {
    return groupOf(this).driven
  }

  set driven(driven: boolean) {
    groupOf(this).driven = driven
  }

  /** Numbers that the application sets for drivers: `inputs.set('age', 40)`. */
  get inputs(): NamedInputs {
    return groupOf(this).inputs
  }

  /** The time for drivers with a delay; replace it if frames are not drawn in real time. */
  get clock(): Clock {
    return groupOf(this).clock
  }

  /** @throws FurrowError when it cannot tell the time. */
  set clock(clock: Clock) {
    groupOf(this).clock = clock
  }

  /** Whether `dispose` was called: setters then throw. */
  get isDisposed(): boolean {
    return groupOf(this).isDisposed
  }

  /** Number of faces: instances, or 1 for any other mesh. */
  get faceCount(): number {
    return groupOf(this).faces.length
  }

  /** Names of the areas, in the order of the activations. */
  get areaNames(): string[] {
    return groupOf(this).areaNames
  }

  /** The area of that name, as it was given; undefined if there is none. */
  getArea(name: string): Area<ArraySlice> | undefined {
    return groupOf(this).getArea(name)
  }

  /** Whether an area of that name exists. */
  hasArea(name: string): boolean {
    return groupOf(this).hasArea(name)
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
    groupOf(this).setActivation(area, value, instance)
  }

  /**
   * Activates several areas, as `setActivation` does, but ignores names that no area has, and allocates nothing.
   *
   * @param values 0..1, in the order of the names; clamped.
   * @param instance index of an instance, 0 by default.
   * @throws FurrowError when there are fewer values than names, no such instance, or the wrinkles were disposed of.
   */
  setActivations(names: readonly string[], values: Float32Array, instance = 0): void {
    groupOf(this).setActivations(names, values, instance)
  }

  /**
   * The activation of an area, 0..1, as of the last frame or `setActivation`.
   *
   * @throws FurrowError when no area has that name.
   */
  getActivation(area: string, instance = 0): number {
    return groupOf(this).getActivation(area, instance)
  }

  /**
   * Sets an area's activation at rest, to which drivers add. Animations of a file do this.
   *
   * @param value 0..1; clamped, with one warning.
   * @throws FurrowError when no area has that name, the value is not a number, there is no such instance, or the wrinkles were disposed of.
   */
  setRestingActivation(area: string, value: number, instance = 0): void {
    groupOf(this).setRestingActivation(area, value, instance)
  }

  /**
   * The activation of an area at rest, 0..1.
   *
   * @throws FurrowError when no area has that name.
   */
  getRestingActivation(area: string, instance = 0): number {
    return groupOf(this).getRestingActivation(area, instance)
  }

  /**
   * Whether blendshapes, joints, tension or other areas drive an area now, so that `setActivation` lasts until the next frame only.
   * False for names that no area has.
   */
  isDriven(area: string): boolean {
    return groupOf(this).isDriven(area)
  }

  /** The drivers in force, in the order in which they were added; see `addDrivers` and `setDrivers`. */
  get drivers(): readonly WrinkleDriver[] {
    return groupOf(this).drivers
  }

  /** Expressions of the file: those among the drivers, then those of a VRM. */
  get expressions(): readonly Expression[] {
    return groupOf(this).expressions
  }

  /** Registers a function to be called by `dispose`. */
  onDispose(dispose: () => void): void {
    groupOf(this).onDispose(dispose)
  }

  /** Restores the material, and frees what no other face uses. */
  dispose(): void {
    groupOf(this).dispose()
  }
}
