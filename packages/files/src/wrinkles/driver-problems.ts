import { driversOf, type WrinkleDriver } from 'furrow'
import {
  type DriverPlan,
  DriverProgram,
  measuredSource,
  planDrivers,
  targetSource,
  valueSource,
} from 'furrow/internal'

/**
 * Faults in drivers (rules that control areas of wrinkles). They cause only warnings, because a loader skips faulty
 * drivers and runs the others.
 */
export interface DriverProblems {
  /** Driver types that are neither built in nor registered. Each is listed once. */
  unknownTypes: readonly string[]
  /** Blendshapes and joints that the file lacks, e.g. `target "jawOpen" of a driver of area "chin"`. */
  missing: readonly string[]
  /** Names of areas that drive themselves. */
  cyclicAreas: readonly string[]
}

/** Checks drivers against the names of blendshapes and joints in a file. */
export function findDriverProblems(
  drivers: readonly WrinkleDriver[],
  targetNames: readonly string[],
  jointNames: readonly string[],
): DriverProblems {
  const plan = planDrivers(drivers)
  // A muscle is a valid target: expression players compute a blendshape for each muscle.
  const muscles = driversOf('muscle', drivers).map(({ name }) => name)
  const { missing } = new DriverProgram(plan, {
    target: targetSource(plan.inputs.target, [...targetNames, ...muscles]),
    joint: measuredSource(plan.inputs.joint.map((input) => missingJoints(input, jointNames))),
    value: valueSource(plan.inputs.value),
  })
  return { unknownTypes: plan.unknownTypes, missing, cyclicAreas: plan.cyclicAreas }
}

function missingJoints({ from, joint }: DriverPlan['inputs']['joint'][number], names: readonly string[]) {
  return [from, joint].filter((name) => !names.includes(name)).map((name) => `joint "${name}"`)
}
