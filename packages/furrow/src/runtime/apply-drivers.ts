import { wrongArgument } from '../core/argument.ts'
import { FurrowError } from '../core/error.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'

/**
 * Calls `apply`, and reports malformed drivers as a FurrowError.
 *
 * @param drivers drivers that the application passed.
 * @param who name of the caller in errors.
 * @param apply adds the drivers to a face and binds their inputs.
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
