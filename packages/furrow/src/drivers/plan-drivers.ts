import { type DriverPlan, planBy } from './plan.ts'
import { definitionOf, type WrinkleDriver } from './registry.ts'

/** Orders the drivers of a face for evaluation. Drivers of unknown type are left out. */
export function planDrivers(drivers: readonly WrinkleDriver[]): DriverPlan {
  return planBy(definitionOf, drivers)
}
