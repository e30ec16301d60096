import {
  driversOf,
  FurrowError,
  type Link,
  type MuscleDriver,
  parseDrivers,
  type WrinkleDriver,
} from 'furrow'
import { canonicalTargetName } from 'furrow/internal'
import type { StudioDocument } from './document.ts'
import { changed, findNamed, kept } from './names.ts'
import { otherSide } from './sides.ts'

/** A blendshape whose weight is at most this counts as not set. */
export const UNSET = 0.01

/**
 * Makes the current pose activate an area (a group of wrinkles) fully. Replaces the area's blendshape drivers by one driver: a weighted sum of
 * the blendshapes that are set. The sum is 1 in this pose.
 *
 * @param weights blendshape weights by name, 0..1.
 * @throws FurrowError if drivers of type `conflict` cancel all blendshapes that are set.
 */
export function recordPose(
  document: StudioDocument,
  area: string,
  weights: ReadonlyMap<string, number>,
): StudioDocument {
  findNamed(document.areas, area, 'area')
  const isSet = ([, weight]: readonly [string, number]) => Math.abs(weight) > UNSET
  const set = [...applyConflicts(document.drivers, weights)].filter(isSet)
  if (set.length === 0 && [...weights].some(isSet)) throw cancelledError([...weights].filter(isSet))
  const others = document.drivers.filter((driver) => driver.type !== 'morph' || areaOf(driver) !== area)
  if (set.length === 0) return { ...document, drivers: others }
  // The factors `weight / sum(weight * weight)` form the shortest vector for which `sum(factor * weight)` is 1.
  const squares = set.reduce((sum, [, weight]) => sum + weight * weight, 0)
  const targets = set.map(([name, weight]): Link => ({ name, weight: rounded(weight / squares) }))
  return addDriver({ ...document, drivers: others }, { type: 'morph', area, targets, rule: 'sum' })
}

/** For each pair of blendshapes that cancel each other, subtracts the smaller weight from both weights. */
function applyConflicts(
  drivers: readonly WrinkleDriver[],
  weights: ReadonlyMap<string, number>,
): Map<string, number> {
  const left = new Map(weights)
  for (const { targets } of driversOf('conflict', drivers)) {
    const [a, b] = targets.map(canonicalTargetName)
    const common = Math.min(left.get(a) ?? 0, left.get(b) ?? 0)
    if (!(common > 0)) continue
    for (const name of [a, b]) left.set(name, left.get(name)! - common)
  }
  return left
}

function cancelledError(set: readonly (readonly [string, number])[]): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: 'the blendshapes that are set cancel each other',
    value: set.map(([name]) => name).join(', '),
    remedy: 'set other blendshapes, or remove the driver of type conflict',
  })
}

/** @throws FurrowError if the driver is invalid. */
export function setDriver(document: StudioDocument, index: number, driver: WrinkleDriver): StudioDocument {
  const [checked] = read(document, driver)
  return { ...document, drivers: document.drivers.map((old, i) => (i === index ? checked : old)) }
}

/** @throws FurrowError if the driver is invalid. */
export function addDriver(document: StudioDocument, driver: WrinkleDriver): StudioDocument {
  return { ...document, drivers: [...document.drivers, ...read(document, driver)] }
}

function read({ areas }: StudioDocument, driver: WrinkleDriver): WrinkleDriver[] {
  return parseDrivers(
    [driver],
    areas.map(({ name }) => name),
    'Studio',
  )
}

export function removeDriver(document: StudioDocument, index: number): StudioDocument {
  return { ...document, drivers: document.drivers.filter((_, i) => i !== index) }
}

export function renameInDrivers(
  drivers: readonly WrinkleDriver[],
  name: string,
  newName: string,
): readonly WrinkleDriver[] {
  const rename = (area: string) => (area === name ? newName : area)
  return changed(drivers, (driver) => mapAreas(driver, (area) => [rename(area)]))
}

/**
 * Removes the drivers that activate an area, and removes the area from the inputs of other drivers. A muscle also moves the skin. It therefore
 * stays, but no longer activates the area.
 */
export function removeFromDrivers(drivers: readonly WrinkleDriver[], name: string): readonly WrinkleDriver[] {
  const free = changed(drivers, (driver) => {
    if (driver.type !== 'muscle' || areaOf(driver) !== name) return driver
    const { area, ...muscle } = driver as MuscleDriver
    return muscle
  })
  const others = kept(free, (driver) => areaOf(driver) !== name)
  const unread = changed(others, (driver) => mapAreas(driver, (area) => (area === name ? [] : [area])))
  return kept(unread, (driver) => driver.type !== 'area' || (driver as { areas: Link[] }).areas.length > 0)
}

export function copyDrivers(
  drivers: readonly WrinkleDriver[],
  name: string,
  newName: string,
): WrinkleDriver[] {
  return drivers.flatMap((driver) => {
    if (areaOf(driver) !== name) return []
    if (driver.type !== 'muscle') return [{ ...driver, area: newName }]
    // A copied muscle would pull the skin twice. The copy is a driver that reads the muscle's blendshape instead.
    const targets = [{ name: (driver as MuscleDriver).name }]
    return parseDrivers([{ type: 'morph', area: newName, targets }], [newName], 'Studio')
  })
}

/** Returns a blendshape driver that reads the blendshapes of the other side of the face. Returns other drivers unchanged. */
export function mirrorDriver(driver: WrinkleDriver): WrinkleDriver {
  if (driver.type !== 'morph') return driver
  const { targets } = driver as WrinkleDriver & { targets: Link[] }
  return {
    ...driver,
    targets: targets.map((link) => ({ ...link, name: otherSide(link.name) })),
  } as WrinkleDriver
}

/**
 * Applies `map` to all area names in a driver: the area that it activates, its inputs, and the activations of an expression. Returns the same
 * object if nothing changes.
 */
function mapAreas(driver: WrinkleDriver, map: (area: string) => string[]): WrinkleDriver {
  const fields: Record<string, unknown> = { ...driver }
  if (typeof fields.area === 'string') fields.area = map(fields.area)[0] ?? fields.area
  if (driver.type === 'area') {
    fields.areas = (fields.areas as Link[]).flatMap((link) =>
      map(link.name).map((name) => ({ ...link, name })),
    )
  }
  if (driver.type === 'expression') {
    const activations = fields.activations as { area: string; activation: number }[]
    fields.activations = activations.flatMap((item) => map(item.area).map((area) => ({ ...item, area })))
  }
  return JSON.stringify(fields) === JSON.stringify(driver) ? driver : (fields as WrinkleDriver)
}

/** Returns the area that a driver activates, or undefined. */
export function areaOf(driver: WrinkleDriver): string | undefined {
  return 'area' in driver && typeof driver.area === 'string' ? driver.area : undefined
}

/** Whether a driver activates an area. */
export function isDriven({ drivers }: Pick<StudioDocument, 'drivers'>, name: string): boolean {
  return drivers.some((driver) => areaOf(driver) === name)
}

/** Whether an area is visible at rest, or a driver activates it. */
export function isActivated(document: StudioDocument, name: string): boolean {
  const isAtRest = document.areas.some((area) => area.name === name && area.activation > 0)
  return isAtRest || isDriven(document, name)
}

function rounded(weight: number): number {
  return Number(weight.toPrecision(4))
}
