import { AreaActivation } from './area.ts'
import type { Driver } from './driver.ts'
import { Delay } from './time.ts'
import type { WrinkleDriver } from './types.ts'
import { driversOf } from './types.ts'

/** What a face remembers from one frame to the next. */
export interface DriverState {
  /** Activations as they were. */
  before: Float64Array
  /** Whether they mean anything yet. */
  started: boolean
}

/**
 * Joins all drivers of a face: per area the activation at rest and what each driver gives, at most 1; then what areas give each
 * other; then the delay. Nothing is allocated by `update`.
 */
export class DriverSum {
  /** Areas that anything moves. */
  readonly areaNames: readonly string[]
  /** In the order of `areaNames`, 0..1. */
  readonly activations: Float32Array
  /** Areas whose drivers are left out, since they drive themselves. */
  readonly cyclic: readonly string[]
  /** One number: the time since the face was brought up to date. In an array, since a number that is handed over may be allocated. */
  readonly seconds = new Float64Array(1)
  readonly #drivers: readonly { driver: Driver; places: Uint16Array }[]
  readonly #areas: AreaActivation
  readonly #delay: Delay

  /**
   * @param drivers each brought up to date before `update`.
   * @param all the file's drivers, of which those between areas and those of time are taken from here.
   */
  constructor(drivers: readonly Driver[], all: readonly WrinkleDriver[]) {
    const between = driversOf('area', all)
    const areaNames = [
      ...new Set([
        ...drivers.flatMap(({ areaNames }) => areaNames),
        ...between.flatMap(({ area, areas }) => [area, ...areas.map(({ name }) => name)]),
        ...driversOf('time', all).map(({ area }) => area),
      ]),
    ]
    this.areaNames = areaNames
    this.activations = new Float32Array(areaNames.length)
    this.#drivers = drivers.map((driver) => ({
      driver,
      places: Uint16Array.from(driver.areaNames, (name) => areaNames.indexOf(name)),
    }))
    this.#areas = new AreaActivation(between, areaNames)
    this.cyclic = this.#areas.cyclic
    this.#delay = new Delay(driversOf('time', all), areaNames)
  }

  /** What a face needs to be told apart from others with the same drivers. */
  createState(): DriverState {
    return { before: new Float64Array(this.areaNames.length), started: false }
  }

  /**
   * Brings `activations` up to date.
   *
   * @param resting activations at rest, in the order of `areaNames`.
   */
  update(resting: ArrayLike<number>, state: DriverState): void {
    const { activations } = this
    for (let i = 0; i < activations.length; i++) activations[i] = resting[i]
    for (let i = 0; i < this.#drivers.length; i++) this.#add(this.#drivers[i].driver, this.#drivers[i].places)
    this.#areas.addTo(activations)
    if (!state.started) state.before.set(activations)
    state.started = true
    this.#delay.follow(activations, state.before, this.seconds)
  }

  #add(driver: Driver, places: Uint16Array): void {
    const from = driver.activations
    const to = this.activations
    for (let i = 0; i < places.length; i++) to[places[i]] = Math.min(1, to[places[i]] + from[i])
  }
}
