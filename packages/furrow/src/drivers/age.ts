import { curveAt } from './curve.ts'
import { areasOf, type Driver } from './driver.ts'
import type { AgeDriver } from './types.ts'

/** Years within which faces are drawn; drivers' curves are constant beyond their ends. */
export const AGES = { youngest: 20, oldest: 80 } as const

/** Activates areas by the person's age: wrinkles that stay. Nothing is allocated by `update`. */
export class AgeActivation implements Driver {
  readonly areaNames: readonly string[]
  readonly activations: Float32Array
  readonly missing: readonly string[] = []
  readonly #drivers: readonly AgeDriver[]
  readonly #places: Uint16Array
  #years = Number.NaN

  constructor(drivers: readonly AgeDriver[]) {
    const { areaNames, places } = areasOf(drivers)
    this.areaNames = areaNames
    this.activations = new Float32Array(areaNames.length)
    this.#drivers = drivers
    this.#places = places
  }

  /** Brings `activations` up to date. */
  update(years: number): void {
    if (years === this.#years) return
    this.#years = years
    this.activations.fill(0)
    for (const [i, { curve }] of this.#drivers.entries()) {
      const place = this.#places[i]
      this.activations[place] = Math.min(1, this.activations[place] + curveAt(curve, years))
    }
  }
}
