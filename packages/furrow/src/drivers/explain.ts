import { AgeActivation } from './age.ts'
import { curveAt } from './curve.ts'
import { BoundLinks, type Joined } from './links.ts'
import { MorphActivation } from './morph.ts'
import { DriverSum } from './sum.ts'
import {
  type AgeDriver,
  type AreaDriver,
  driversOf,
  type Link,
  type MorphDriver,
  type WrinkleDriver,
} from './types.ts'

/** What one link gives to its driver, before the driver's rule and curve. */
export interface LinkPart {
  link: Link
  value: number
}

/** What one driver gives to an area. */
export interface Part {
  driver: MorphDriver | AreaDriver | AgeDriver
  /** 0..1; all of an area's and its activation at rest add up to at most 1. */
  activation: number
  /** None where the driver has no links. */
  links: LinkPart[]
}

/** Why an area shows. */
export interface Explanation {
  area: string
  activation: number
  resting: number
  parts: Part[]
}

/** What the drivers are to be asked about. */
export interface Situation {
  /** Names of the mesh's blendshapes, and their weights in the same order. */
  targetNames: readonly string[]
  weights: ArrayLike<number>
  /** Years. */
  age: number
}

/**
 * Says of each area how much of it shows and which link gave it, as far as blendshapes, other areas and age decide; joints and
 * tension need the moving mesh. Delays are left out: it is where the face comes to rest.
 *
 * @param areas with their activations at rest.
 */
export function explain(
  drivers: readonly WrinkleDriver[],
  areas: readonly { name: string; activation?: number }[],
  { targetNames, weights, age }: Situation,
): Explanation[] {
  const morph = new MorphActivation(driversOf('morph', drivers), targetNames, driversOf('conflict', drivers))
  morph.update(weights)
  const ages = new AgeActivation(driversOf('age', drivers))
  ages.update(age)
  const sum = new DriverSum([morph, ages], driversOf('area', drivers))
  const resting = new Map(areas.map(({ name, activation = 0 }) => [name, activation]))
  sum.update(
    sum.areaNames.map((name) => resting.get(name) ?? 0),
    sum.createState(),
  )
  const shown = new Map(sum.areaNames.map((name, i) => [name, sum.activations[i]]))
  const cyclic = new Set(sum.cyclic)
  return areas.map(({ name, activation = 0 }) => ({
    area: name,
    activation: shown.get(name) ?? activation,
    resting: activation,
    parts: [
      ...driversOf('morph', drivers).flatMap((driver, i) =>
        driver.area === name ? [partOf(driver, driver.targets, morph.explain(i, weights))] : [],
      ),
      ...ofArea('area', name, cyclic.has(name) ? [] : drivers).map((driver) =>
        partOf(driver, driver.areas, explainArea(driver, sum)),
      ),
      ...ofArea('age', name, drivers).map((driver) => ({
        driver,
        activation: curveAt(driver.curve, age),
        links: [],
      })),
    ],
  }))
}

function ofArea<T extends 'area' | 'age'>(type: T, area: string, drivers: readonly WrinkleDriver[]) {
  return driversOf(type, drivers).filter((driver) => driver.area === area)
}

function partOf(
  driver: MorphDriver | AreaDriver,
  links: readonly Link[],
  { activation, links: values }: Joined,
): Part {
  return { driver, activation, links: links.map((link, i) => ({ link, value: values[i] })) }
}

/** Other areas as they show. */
function explainArea({ areas, rule, curve }: AreaDriver, { areaNames, activations }: DriverSum): Joined {
  const find = (name: string) => [areaNames.indexOf(name)]
  return new BoundLinks([{ area: 0, links: areas, rule, curve }], find, 'explain').explain(0, activations)
}
