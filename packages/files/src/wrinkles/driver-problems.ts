import { driversOf, type WrinkleDriver } from 'furrow'
import {
  type DriverPlan,
  DriverProgram,
  measuredSource,
  planDrivers,
  targetSource,
  valueSource,
} from 'furrow/internal'

/** Problems with drivers that cause only warnings: a loader skips these drivers and runs the others. */
export interface DriverProblems {
  /** Types that are neither built in nor registered, without duplicates. */
  unknownTypes: readonly string[]
  /** Inputs that the face lacks, e.g. `target "jawOpen" of a driver of area "chin"`. */
  missing: readonly string[]
  /** Areas that drive themselves. */
  cyclicAreas: readonly string[]
}

/** Checks drivers against the names that a face has. */
export function findDriverProblems(
  drivers: readonly WrinkleDriver[],
  targetNames: readonly string[],
  jointNames: readonly string[],
): DriverProblems {
  const plan = planDrivers(drivers)
  // Expression players compute a target for each muscle.
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
