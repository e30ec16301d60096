import { sentence } from '../core/error.ts'
import { AgeActivation } from '../drivers/age.ts'
import { expressionsOf } from '../drivers/expression.ts'
import { type DriverState, DriverSum } from '../drivers/sum.ts'
import { driversOf, isKnownDriver, type WrinkleDriver } from '../drivers/types.ts'
import type { AnyRenderer } from './atlas/influence-atlas.ts'
import type { Face } from './face.ts'
import { ageSource } from './sources/age.ts'
import { boneSource } from './sources/bone.ts'
import { morphSource } from './sources/morph.ts'
import type { DriversOptions, Source, SourceType } from './sources/source.ts'
import { tensionSource } from './sources/tension.ts'
import type { WrinklesBase } from './wrinkles-base.ts'

/** Lets a file's drivers move wrinkles. */
export type AddDrivers = (
  wrinkles: WrinklesBase,
  drivers: readonly WrinkleDriver[],
  options?: DriversOptions,
) => void

/**
 * Lets a file's drivers move wrinkles, by themselves, each time before the mesh is drawn, as long as `wrinkles.driven` is true
 * and the wrinkles are not disposed of. Per area they add to the activation at rest, to at most 1. Call it once.
 *
 * @param drivers types this version does not know are left out with a warning, and so is what they name and the mesh does not
 *   have: targets, joints, areas.
 */
export const addDrivers: AddDrivers = (wrinkles, drivers, options = {}) =>
  playDrivers(wrinkles, drivers, options, tensionSource)

/**
 * The same for each renderer's way to measure tension.
 *
 * @param tension plays drivers of that type.
 */
export function playDrivers(
  wrinkles: WrinklesBase,
  drivers: readonly WrinkleDriver[],
  options: DriversOptions,
  tension: SourceType,
): void {
  wrinkles.expressions = expressionsOf(drivers)
  const known = drivers.filter(isKnownDriver)
  const sources = [morphSource, boneSource, tension, ageSource]
    .filter(({ types }) => known.some(({ type }) => types.includes(type)))
    .map(({ create }) => create(wrinkles, known, options))
  const sum = new DriverSum(
    sources.map(({ driver }) => driver),
    known,
  )
  warn(wrinkles, [
    ...drivers.filter((driver) => !isKnownDriver(driver)).map(({ type }) => `driver of type "${type}"`),
    ...sources.flatMap(({ driver }) => driver.missing),
    ...sum.cyclic.map((area) => `an end to the drivers of area "${area}", which drives itself`),
  ])
  if (sum.areaNames.length === 0) return
  const play = new Play(wrinkles, sources, sum, driversOf('time', known).length > 0)
  const moved = [
    ...sources.flatMap(({ driver }) => (driver instanceof AgeActivation ? [] : driver.areaNames)),
    ...driversOf('area', known).map(({ area }) => area),
  ]
  wrinkles.onDrive((face, instance, renderer) => play.drive(face, instance, renderer), moved)
}

/** Drivers at work on the faces of one mesh. Nothing is allocated by `drive` once a face was seen. */
class Play {
  readonly #wrinkles: WrinklesBase
  readonly #sources: readonly Source[]
  readonly #sum: DriverSum
  readonly #takesTime: boolean
  readonly #faces: { state: DriverState; seen: Float64Array }[] = []
  readonly #resting: Float32Array
  /** Of the sum's areas among the face's, as long as the face has these; one beyond the last stands for none. */
  readonly #places: Uint16Array
  #areas: Face['areas'] | null = null

  constructor(wrinkles: WrinklesBase, sources: readonly Source[], sum: DriverSum, takesTime: boolean) {
    this.#wrinkles = wrinkles
    this.#sources = sources
    this.#sum = sum
    this.#takesTime = takesTime
    this.#resting = new Float32Array(sum.areaNames.length)
    this.#places = new Uint16Array(sum.areaNames.length)
  }

  drive(face: Face, instance: number, renderer: AnyRenderer): void {
    if (face.areas !== this.#areas) this.#bind(face)
    for (let i = 0; i < this.#sources.length; i++) this.#sources[i].update(instance, renderer)
    const { values } = face.resting
    for (let i = 0; i < this.#places.length; i++) this.#resting[i] = values[this.#places[i]]
    this.#faces[instance] ??= { state: this.#sum.createState(), seen: new Float64Array(1) }
    const { state, seen } = this.#faces[instance]
    if (this.#takesTime) {
      const now = this.#wrinkles.clock.now()
      this.#sum.seconds[0] = (now - seen[0]) / 1000
      seen[0] = now
    }
    this.#sum.update(this.#resting, state)
    face.activations.take(this.#places, this.#sum.activations)
  }

  /** Areas come and go; those that are gone are said once each time, and the others go on. */
  #bind(face: Face): void {
    this.#areas = face.areas
    const { names } = face.activations
    for (const [i, name] of this.#sum.areaNames.entries()) {
      const place = names.indexOf(name)
      this.#places[i] = place < 0 ? names.length : place
    }
    const gone = this.#sum.areaNames.filter((name) => !names.includes(name))
    warn(
      this.#wrinkles,
      gone.map((name) => `area "${name}"`),
    )
  }
}

function warn({ mesh }: WrinklesBase, missing: readonly string[]): void {
  if (missing.length === 0) return
  console.warn(
    sentence({
      who: 'Wrinkles',
      what: `the drivers of mesh "${mesh.name}" name what is not here`,
      value: missing.join(', '),
      remedy: 'the others move their areas all the same',
    }),
  )
}
