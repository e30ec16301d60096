import { wrongArgument } from '../core/argument.ts'
import { FurrowError } from '../core/error.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'

/**
 * Applies drivers that an application wrote.
 *
 * @param who names the caller in errors.
 * @param apply also finds the drivers' inputs, so that malformed drivers fail here and not in a frame.
 * @throws FurrowError when the drivers are not as `parseDrivers` reads them.
 */
export function applyDrivers(drivers: readonly WrinkleDriver[], who: string, apply: () => void): void {
  if (!Array.isArray(drivers) || !drivers.every((driver) => typeof driver?.type === 'string')) {
    throw wrongArgument(who, 'drivers', drivers, 'a list of objects with a type')
  }
  try {
    apply()
  } catch (error) {
    if (!(error instanceof TypeError)) throw error
    throw new FurrowError(
      {
        who,
        problem: 'a driver lacks fields, or they have the wrong type',
        value: drivers.map(({ type }) => type).join(', '),
        remedy: 'read them by parseDrivers, which fills in defaults and says what is wrong',
      },
      { cause: error },
    )
  }
}
