import type { MorphDriver } from '../drivers/morph/definition.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import { areSums, MorphDrivers, type ReadWeights } from './morph-drivers.ts'
import type { WrinkleFaces } from './wrinkle-faces.ts'

/** How an engine drives the areas of its faces. */
export interface DriverParts<Own> {
  /** Names of a face's blendshapes, in the order of their weights. */
  targetNames(own: Own): readonly string[]
  weightReader(own: Own, names: readonly string[]): ReadWeights
  /** Fetches what drivers of any type take. */
  fetchAny(): Promise<(own: Own) => void>
}

/**
 * Prepares the drivers of a file. Most files add up blendshapes, named as their mesh names them; what any others take is fetched.
 *
 * @param names of the blendshapes of the face in the file. Copies may have others: what they take is fetched when they are driven.
 * @returns what lets them activate the areas of a face.
 */
export async function prepareDrivers<Own extends WrinkleFaces<never>>(
  names: readonly string[],
  drivers: readonly WrinkleDriver[],
  { targetNames, weightReader, fetchAny }: DriverParts<Own>,
): Promise<(own: Own) => void> {
  let any: Promise<(own: Own) => void> | undefined
  if (!areSums(drivers) || !hasTargets(names, drivers)) return fetchAny()
  const driveAny = async (own: Own) => {
    try {
      any ??= fetchAny()
      const drive = await any
      if (!own.isDisposed) drive(own)
    } catch (error) {
      console.warn((error as Error).message)
    }
  }
  return (own) => {
    const names = targetNames(own)
    if (hasTargets(names, drivers)) {
      own.setDrivers(new MorphDrivers(drivers, names, weightReader(own, names), () => driveAny(own)))
    } else driveAny(own)
  }
}

function hasTargets(names: readonly string[], drivers: readonly MorphDriver[]): boolean {
  return drivers.every(({ targets }) => targets.every(({ name }) => names.includes(name)))
}
