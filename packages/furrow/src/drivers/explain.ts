import {
  type AgeDriver,
  type AreaDriver,
  driversOf,
  type Link,
  type MorphDriver,
  type WrinkleDriver,
} from '../core/driver-types.ts'
import { AgeActivation } from './age.ts'
import { Conflicts } from './conflict.ts'
import { curveAt } from './curve.ts'
import { MorphActivation } from './morph.ts'
import { DriverSum } from './sum.ts'
import { targetFinder } from './target-names.ts'

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
  const inputs = weightsByName(drivers, targetNames, weights)
  const cyclic = new Set(sum.cyclic)
  return areas.map(({ name, activation = 0 }) => ({
    area: name,
    activation: shown.get(name) ?? activation,
    resting: activation,
    parts: [
      ...ofArea('morph', name, drivers).map((driver) => partOf(driver, driver.targets, inputs)),
      ...ofArea('area', name, cyclic.has(name) ? [] : drivers).map((driver) =>
        partOf(driver, driver.areas, (area) => shown.get(area) ?? resting.get(area) ?? 0),
      ),
      ...ofArea('age', name, drivers).map((driver) => ({
        driver,
        activation: curveAt(driver.curve, age),
        links: [],
      })),
    ],
  }))
}

function ofArea<T extends 'morph' | 'area' | 'age'>(
  type: T,
  area: string,
  drivers: readonly WrinkleDriver[],
) {
  return driversOf(type, drivers).filter((driver) => driver.area === area)
}

function partOf(
  driver: MorphDriver | AreaDriver,
  links: readonly Link[],
  inputOf: (name: string) => number,
): Part {
  const parts = links.map((link) => {
    const input = inputOf(link.name)
    return { link, value: link.weight * (link.curve ? curveAt(link.curve, input) : input) }
  })
  const values = parts.map(({ value }) => value)
  const joined = {
    sum: () => values.reduce((a, b) => a + b, 0),
    product: () => values.reduce((a, b) => a * b, 1),
    max: () => Math.max(...values),
    min: () => Math.min(...values),
  }[driver.rule]()
  return { driver, activation: curveAt(driver.curve, joined), links: parts }
}

/** Weights as drivers see them: conflicts resolved, the mean of split shapes. */
function weightsByName(
  drivers: readonly WrinkleDriver[],
  targetNames: readonly string[],
  weights: ArrayLike<number>,
): (name: string) => number {
  const find = targetFinder(targetNames)
  const conflicts = new Conflicts(driversOf('conflict', drivers), find, targetNames.length)
  const resolved = conflicts.any ? conflicts.resolve(weights, 0) : weights
  return (name) => {
    const places = find(name)
    return places.reduce((sum, place) => sum + resolved[place] / places.length, 0) || 0
  }
}
