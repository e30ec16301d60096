import { BoneActivation, driversOf, isKnownDriver, MorphActivation, type WrinkleDriver } from 'furrow'

/** Types of drivers that this version does not know, each once. */
export function unknownTypes(drivers: readonly WrinkleDriver[]): string[] {
  return [...new Set(drivers.filter((driver) => !isKnownDriver(driver)).map(({ type }) => type))]
}

/**
 * What drivers name and a face does not have, e.g. `target "jawOpen" of a driver of area "chin"`. It counts as 0, so
 * that it is worth a warning and no more.
 */
export function missingOf(
  drivers: readonly WrinkleDriver[],
  targetNames: readonly string[],
  jointNames: readonly string[],
): string[] {
  const morph = new MorphActivation(driversOf('morph', drivers), targetNames, driversOf('conflict', drivers))
  const bone = new BoneActivation(
    driversOf('bone', drivers),
    jointNames,
    new Float64Array(16 * jointNames.length),
  )
  return [...morph.missing, ...bone.missing]
}
