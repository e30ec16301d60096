import { wrongArgument } from '../core/argument.ts'
import { FurrowError } from '../core/error.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'

/**
 * Applies drivers written by the application.
 *
 * @param who name of the caller in errors.
 * @param apply applies the drivers and binds their inputs, so that malformed drivers fail here instead of in a frame.
 * @throws FurrowError if a driver is malformed.
 */
export function applyDrivers(drivers: readonly WrinkleDriver[], who: string, apply: () => void): void {
  if (!Array.isArray(drivers) || !drivers.every((driver) => typeof driver?.type === 'string')) {
    throw wrongArgument(who, 'drivers', drivers, 'an array of objects with a type')
  }
  try {
    apply()
  } catch (error) {
    if (!(error instanceof TypeError)) throw error
    throw new FurrowError(
      {
        who,
        problem: 'a driver has missing fields, or fields of the wrong type',
        value: drivers.map(({ type }) => type).join(', '),
        remedy: 'pass the drivers through parseDrivers, which fills in defaults and reports invalid fields',
      },
      { cause: error },
    )
  }
}
