import type { WrinkleDriver, WrinkleSet } from 'furrow'
import type { Wrinkles } from '../../../../stage/stage.ts'
import type { Dial } from './dials.ts'
import { FaceDrivers, type FaceState } from './face-drivers.ts'

/**
 * The areas of the face that is shown, as its drivers activate them. They run here instead of in the engine, so that the areas' sliders
 * follow at once; an area that was set by hand stays as it is until what drives it changes.
 */
export class DrivenAreas implements FaceState {
  /** Numbers that an application would set for drivers, by name: age in years, stress. */
  readonly inputs = new Map<string, number>()
  readonly resting = new Map<string, number>()
  #wrinkles: Wrinkles | null = null
  #drivers = new FaceDrivers(null, [], this)

  get drivers(): FaceDrivers {
    return this.#drivers
  }

  /** Takes the areas of other wrinkles, as they are at rest, and their drivers; `drive` then sets the areas. Null for a plain face. */
  wear(
    wrinkles: Wrinkles | null,
    areas: WrinkleSet<unknown>['areas'],
    drivers: readonly WrinkleDriver[],
  ): void {
    this.#wrinkles = wrinkles
    if (wrinkles) wrinkles.driven = false
    this.resting.clear()
    for (const { name, activation } of areas) this.resting.set(name, activation ?? 0)
    this.#drivers = new FaceDrivers(wrinkles, drivers, this)
  }

  /** Lets other drivers activate the areas. */
  setDrivers(drivers: readonly WrinkleDriver[]): void {
    const before = this.#drivers.areaNames
    this.#drivers = new FaceDrivers(this.#wrinkles, drivers, this)
    const free = before.filter((area) => !this.#drivers.areaNames.includes(area))
    for (const area of free) this.#setActivation(area, this.resting.get(area) ?? 0)
    this.drive()
  }

  /** Sets all areas that are driven as the face's pose has them. */
  drive(): void {
    const activations = this.#drivers.evaluate()
    for (const [i, name] of this.#drivers.areaNames.entries()) this.#setActivation(name, activations[i])
  }

  /** Changes what drivers read, and sets the areas whose activation that changes; the others stay as they were set by hand. */
  driveAfter(change: () => void, isWanted: (area: string) => boolean = () => true): void {
    const before = this.#drivers.evaluate().slice()
    change()
    const after = this.#drivers.evaluate()
    for (const [i, name] of this.#drivers.areaNames.entries()) {
      if (after[i] !== before[i] && isWanted(name)) this.#setActivation(name, after[i])
    }
  }

  /** Shows another activation at rest. */
  rest(area: string, activation: number): void {
    this.driveAfter(() => this.resting.set(area, activation))
    if (!this.#drivers.areaNames.includes(area)) this.#setActivation(area, activation)
  }

  /** Existing areas that a blendshape drives. */
  drivenBy(target: string): string[] {
    return this.#drivers.areasOf(target).filter((name) => this.#wrinkles?.hasArea(name))
  }

  /** Of a number that an application would set for drivers, in its own unit. */
  inputDial(name: string): Dial {
    return {
      name,
      read: () => this.#drivers.input(name),
      write: (value) => this.driveAfter(() => this.inputs.set(name, value)),
    }
  }

  #setActivation(area: string, activation: number): void {
    if (this.#wrinkles?.hasArea(area)) this.#wrinkles.setActivation(area, activation)
  }
}
