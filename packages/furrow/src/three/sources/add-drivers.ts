import { driversOf, type WrinkleDriver } from '../../drivers/registry.ts'
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
 */
export const addDrivers: AddDrivers = addDriversBy(BINDINGS)

/** `addDrivers` with a renderer's ways to read inputs. */
export function addDriversBy(bindings: InputBindings): AddDrivers {
  return (wrinkles, drivers, options = {}) => {
    addMuscles(wrinkles.mesh, driversOf('muscle', drivers))
    bindDrivers(wrinkles, drivers, () => options, bindings).bind()
  }
}
