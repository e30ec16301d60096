import type { WrinkleDriver, WrinkleSet } from 'furrow'
import type { Wrinkles } from '../../../../stage/stage.ts'
import type { Dial } from './dials.ts'
import { FaceDrivers, type FaceState } from './face-drivers.ts'

/**
 * Areas of the shown face, activated by drivers. Evaluated here instead of in the engine, so that sliders follow immediately. An area
 * set by hand keeps its activation until its inputs change.
 */
export class DrivenAreas implements FaceState {
  /** Custom inputs by name, set by the application: age in years, stress. */
  readonly inputs = new Map<string, number>()
  readonly resting = new Map<string, number>()
  #wrinkles: Wrinkles | null = null
  #drivers = new FaceDrivers(null, [], this)

  get drivers(): FaceDrivers {
    return this.#drivers
  }

  /** Takes over the resting areas and drivers of other wrinkles, or of a plain face. Call `drive` to set the areas. */
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

  /** Replaces the drivers. */
  setDrivers(drivers: readonly WrinkleDriver[]): void {
    const before = this.#drivers.areaNames
    this.#drivers = new FaceDrivers(this.#wrinkles, drivers, this)
    const free = before.filter((area) => !this.#drivers.areaNames.includes(area))
    for (const area of free) this.#setActivation(area, this.resting.get(area) ?? 0)
    this.drive()
  }

  /** Sets all driven areas to the current pose. */
  drive(): void {
    const activations = this.#drivers.evaluate()
    for (const [i, name] of this.#drivers.areaNames.entries()) this.#setActivation(name, activations[i])
  }

  /** Runs a change of inputs and updates the areas whose activation it changes. Other areas keep activations set by hand. */
  applyChange(change: () => void, isWanted: (area: string) => boolean = () => true): void {
    const before = this.#drivers.evaluate().slice()
    change()
    const after = this.#drivers.evaluate()
    for (const [i, name] of this.#drivers.areaNames.entries()) {
      if (after[i] !== before[i] && isWanted(name)) this.#setActivation(name, after[i])
    }
  }

  /** Changes the activation of an area at rest. */
  setResting(area: string, activation: number): void {
    this.applyChange(() => this.resting.set(area, activation))
    if (!this.#drivers.areaNames.includes(area)) this.#setActivation(area, activation)
  }

  /** Returns the existing areas driven by a blendshape. */
  drivenBy(target: string): string[] {
    return this.#drivers.areasOf(target).filter((name) => this.#wrinkles?.hasArea(name))
  }

  /** Custom input: a number set by the application, in its own unit. */
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
