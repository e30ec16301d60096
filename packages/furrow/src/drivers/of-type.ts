import type { DriverOf, DriverType, WrinkleDriver } from './registry.ts'

/** Returns the drivers of one type, in their order. */
export function driversOf<T extends DriverType>(type: T, drivers: readonly WrinkleDriver[]): DriverOf<T>[] {
  return drivers.filter((driver): driver is DriverOf<T> => driver.type === type)
}
