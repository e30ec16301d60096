import { BoneActivation, driversOf, isKnownDriver, MorphActivation, type WrinkleDriver } from 'furrow'

/** Types that this version does not play, each once. */
export function unknownTypes(drivers: readonly WrinkleDriver[]): string[] {
  return [...new Set(drivers.filter((driver) => !isKnownDriver(driver)).map(({ type }) => type))]
}

/** What drivers name and a face does not have, e.g. `target "jawOpen" of a driver of area "chin"`; it counts as 0, so this is worth a warning and no more. */
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
