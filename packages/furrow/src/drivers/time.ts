import type { TimeDriver } from './types.ts'

/**
 * Lets activations follow with a delay, each with its own time to grow and to fade. What is missing shrinks exponentially, so
 * that ten steps of a hundredth of a second and one of a tenth come out alike. Nothing is allocated by `follow`.
 */
export class Delay {
  readonly #places: Uint16Array
  readonly #attacks: Float64Array
  readonly #releases: Float64Array

  /** @param areaNames all areas there are, in the order of the activations. */
  constructor(drivers: readonly TimeDriver[], areaNames: readonly string[]) {
    // Of several for one area the last one counts.
    const last = [...new Map(drivers.map((driver) => [driver.area, driver])).values()]
    this.#places = Uint16Array.from(last, ({ area }) => areaNames.indexOf(area))
    this.#attacks = Float64Array.from(last, ({ attack }) => attack)
    this.#releases = Float64Array.from(last, ({ release }) => release)
  }

  /**
   * @param activations where they are driven to; become where they are now.
   * @param before where they were at the last call; take over where they are now.
   * @param seconds one number: the time since then.
   */
  follow(activations: Float32Array, before: Float64Array, seconds: Float64Array): void {
    for (let i = 0; i < this.#places.length; i++) {
      const place = this.#places[i]
      const missing = activations[place] - before[place]
      const time = missing > 0 ? this.#attacks[i] : this.#releases[i]
      if (time > 0) before[place] += missing * (1 - Math.exp(-seconds[0] / time))
      else before[place] = activations[place]
      activations[place] = before[place]
    }
  }
}
