import { wrongArgument } from '../../core/argument.ts'
import { FurrowError } from '../../core/error.ts'
import { checkOptionNames } from '../../core/nearest-name.ts'
import { driversOf } from '../../drivers/of-type.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'
import { BINDINGS, bindDrivers } from './bind-drivers.ts'
import type { DriversOptions, InputBindings } from './binding.ts'
import { addMuscles } from './muscles.ts'

/** The signature of `addDrivers`. */
export type AddDrivers = (
  wrinkles: WrinklesBase,
  drivers: readonly WrinkleDriver[],
  options?: DriversOptions,
) => void

/**
 * Lets drivers activate areas before each frame, as long as `wrinkles.driven` is true and the wrinkles are not disposed of. They add to
 * an area's activation at rest, up to 1. Muscles become blendshapes of the mesh. Drivers that were added
 * before are replaced, and `wrinkles.expressions` with them.
 *
 * @param wrinkles of the face.
 * @param drivers as in a file. Unknown types are left out with a warning, as are targets, joints and areas that do not exist.
 * @param options a VRM's expressions.
 * @throws FurrowError when `wrinkles` is not a `Wrinkles` or was disposed of, or a driver is not as `parseDrivers` reads it.
 */
export const addDrivers: AddDrivers = addDriversBy(BINDINGS)

/** `addDrivers` with a renderer's ways to read inputs. */
export function addDriversBy(bindings: InputBindings): AddDrivers {
  return (wrinkles, drivers, options = {}) => {
    checkWrinkles(wrinkles, 'addDrivers')
    if (!Array.isArray(drivers) || !drivers.every((driver) => typeof driver?.type === 'string')) {
      throw wrongArgument('addDrivers', 'drivers', drivers, 'a list of objects with a type')
    }
    checkOptionNames(options ?? {}, ['expressions'], 'addDrivers')
    try {
      addMuscles(wrinkles.mesh, driversOf('muscle', drivers))
      bindDrivers(wrinkles, drivers, () => options ?? {}, bindings).bind()
    } catch (error) {
      if (!(error instanceof TypeError)) throw error
      throw malformed(drivers, error)
    }
  }
}

/** Drivers made by hand may lack what a file's cannot. */
function malformed(drivers: readonly WrinkleDriver[], cause: TypeError): FurrowError {
  return new FurrowError(
    {
      who: 'addDrivers',
      what: 'a driver lacks fields, or they have the wrong type',
      value: drivers.map(({ type }) => type).join(', '),
      remedy: 'read them by parseDrivers, which fills in defaults and says what is wrong',
    },
    { cause },
  )
}
