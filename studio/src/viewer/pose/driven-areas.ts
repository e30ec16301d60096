import type { WrinkleDriver, WrinkleSet } from 'furrow'
import type { Wrinkles } from '../../../../stage/stage.ts'
import type { Dial } from './dials.ts'
import { FaceDrivers, type FaceState } from './face-drivers.ts'

/**
 * Lets drivers activate the areas of the face. Sets `Wrinkles.driven` to false and evaluates the drivers itself, so that the sliders of areas
 * show new activations before the next frame. An area that the user has set keeps its activation until its drivers return a new value.
 */
export class DrivenAreas implements FaceState {
  /** Values of custom inputs, such as the age in years or stress. The keys are the names of the inputs. */
  readonly inputs = new Map<string, number>()
  /** Activations of areas at rest, 0..1. */
  readonly resting = new Map<string, number>()
  #wrinkles: Wrinkles | null = null
  #drivers = new FaceDrivers(null, [], this)

  get drivers(): FaceDrivers {
    return this.#drivers
  }

  /** Replaces the wrinkles, areas and drivers. Null removes the wrinkles. Call `drive` afterwards to activate the areas. */
  attach(
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

  setDrivers(drivers: readonly WrinkleDriver[]): void {
    const before = this.#drivers.areaNames
    this.#drivers = new FaceDrivers(this.#wrinkles, drivers, this)
    const free = before.filter((area) => !this.#drivers.areaNames.includes(area))
    for (const area of free) this.#setActivation(area, this.resting.get(area) ?? 0)
    this.drive()
  }

  /** Sets the activations of all driven areas for the current pose. */
  drive(): void {
    const activations = this.#drivers.evaluate()
    for (const [i, name] of this.#drivers.areaNames.entries()) this.#setActivation(name, activations[i])
  }

  /**
   * Runs a function that changes inputs of drivers. Then updates only the areas whose driven activation has changed, because
   * the user may have set other areas by hand.
   *
   * @param isWanted whether to update an area.
   */
  applyChange(change: () => void, isWanted: (area: string) => boolean = () => true): void {
    const before = this.#drivers.evaluate().slice()
    change()
    const after = this.#drivers.evaluate()
    for (const [i, name] of this.#drivers.areaNames.entries()) {
      if (after[i] !== before[i] && isWanted(name)) this.#setActivation(name, after[i])
    }
  }

  /** Changes the resting activation of an area. */
  setResting(area: string, activation: number): void {
    this.applyChange(() => this.resting.set(area, activation))
    if (!this.#drivers.areaNames.includes(area)) this.#setActivation(area, activation)
  }

  /** Returns the names of the face's areas that a blendshape drives. */
  drivenBy(target: string): string[] {
    return this.#drivers.areasOf(target).filter((name) => this.#wrinkles?.hasArea(name))
  }

  /** Returns the dial of a custom input, whose value has its own unit and range. */
  inputDial(name: string): Dial {
    return {
      name,
      read: () => this.#drivers.input(name),
      write: (value) => this.applyChange(() => this.inputs.set(name, value)),
    }
  }

  #setActivation(area: string, activation: number): void {
    if (this.#wrinkles?.hasArea(area)) this.#wrinkles.setActivation(area, activation)
  }
}
