import { type ConflictDriver, driversOf, findTargets, type MorphDriver, type WrinkleDriver } from 'furrow'
import { canonicalTargetName, isKnownDriver, planDrivers } from 'furrow/internal'
import { areaOf } from './drivers.ts'

/** Reason why a driver has less effect than its settings suggest, with a remedy. */
export interface DriverProblem {
  readonly text: string
  readonly remedy: string
  /** Index of the driver whose removal fixes the problem. */
  readonly removes?: number
}

/** Finds problems of the drivers that activate an area. The keys are indices of `drivers`. */
export function driverProblems(
  drivers: readonly WrinkleDriver[],
  area: string,
  targetNames: readonly string[],
): ReadonlyMap<number, DriverProblem> {
  const { cyclicAreas } = planDrivers(drivers)
  const problems = new Map<number, DriverProblem>()
  for (const [index, driver] of drivers.entries()) {
    if (areaOf(driver) !== area) continue
    const problem =
      unknownType(driver) ??
      (driver.type === 'area' && cyclicAreas.includes(area) ? cycle(area, index) : null) ??
      earlierDelay(drivers, driver, index) ??
      (driver.type === 'morph' ? morphProblem(driver as MorphDriver, drivers, targetNames) : null)
    if (problem) problems.set(index, problem)
  }
  return problems
}

/**
 * Returns the indices of the conflicts to list for an area. A conflict is a pair of blendshapes that cancel each other. The list has the
 * pairs with a blendshape that drives this area, and the pairs whose blendshapes drive no area.
 */
export function conflictsOf(drivers: readonly WrinkleDriver[], area: string): number[] {
  const morphs = driversOf('morph', drivers)
  const read = (names: readonly MorphDriver[]) =>
    new Set(names.flatMap(({ targets }) => targets.map(({ name }) => canonicalTargetName(name))))
  const own = read(morphs.filter((driver) => driver.area === area))
  const all = read(morphs)
  return drivers.flatMap((driver, index) => {
    if (driver.type !== 'conflict') return []
    const names = (driver as ConflictDriver).targets.map(canonicalTargetName)
    const concerns = names.some((name) => own.has(name)) || !names.some((name) => all.has(name))
    return concerns ? [index] : []
  })
}

function unknownType(driver: WrinkleDriver): DriverProblem | null {
  if (isKnownDriver(driver)) return null
  return {
    text: `This version does not know drivers of type “${driver.type}”. It is kept in the file.`,
    remedy: 'Drive the area by another one.',
  }
}

function cycle(area: string, removes: number): DriverProblem {
  return {
    text: `${area} drives itself in a circle, so this driver has no effect.`,
    remedy: 'Let this driver read other areas, or remove it.',
    removes,
  }
}

/** Returns a problem if a later driver also delays the area, because only the last delay has an effect. */
function earlierDelay(
  drivers: readonly WrinkleDriver[],
  driver: WrinkleDriver,
  index: number,
): DriverProblem | null {
  if (driver.type !== 'time') return null
  const isLater = drivers.some(
    (other, i) => i > index && other.type === 'time' && areaOf(other) === areaOf(driver),
  )
  if (!isLater) return null
  return { text: 'A later delay of this area counts instead.', remedy: 'Remove this one.', removes: index }
}

function morphProblem(
  { targets, rule }: MorphDriver,
  drivers: readonly WrinkleDriver[],
  targetNames: readonly string[],
): DriverProblem | null {
  const missing = targets.filter(({ name }) => findTargets(name, targetNames).length === 0)
  if (missing.length > 0) {
    const names = missing.map(({ name }) => name).join(', ')
    return { text: `This face has no blendshape ${names}.`, remedy: 'Choose one that it has, or remove it.' }
  }
  const read = new Set(targets.map(({ name }) => canonicalTargetName(name)))
  const index = drivers.findIndex(
    (other) =>
      other.type === 'conflict' &&
      (other as ConflictDriver).targets.every((name) => read.has(canonicalTargetName(name))),
  )
  if (index < 0 || rule === 'max') return null
  const [a, b] = (drivers[index] as ConflictDriver).targets
  const isUnreachable = rule === 'min' || rule === 'product'
  return {
    text: isUnreachable
      ? `${a} and ${b} cancel each other, and this driver needs both: it never shows.`
      : `${a} and ${b} cancel each other: raised together, they show less here than alone.`,
    remedy: isUnreachable
      ? 'Remove the conflict, or one of the two here.'
      : 'Remove the conflict if both are wanted.',
    removes: index,
  }
}
