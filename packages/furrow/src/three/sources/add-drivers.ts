import { driversOf, type WrinkleDriver } from '../../drivers/registry.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'
import { BINDINGS, bindDrivers } from './bind-drivers.ts'
import type { DriversOptions, InputBindings } from './binding.ts'
import { addMuscles } from './muscles.ts'

/** Lets the drivers of a file activate areas. */
export type AddDrivers = (
  wrinkles: WrinklesBase,
  drivers: readonly WrinkleDriver[],
  options?: DriversOptions,
) => void

/**
 * Lets drivers activate areas before each frame, as long as `wrinkles.driven` is true and the wrinkles are not disposed of. Per
 * area they add to the activation at rest, to at most 1. Drivers that were added before are replaced.
 *
 * @param drivers types that nobody here knows are left out with a warning, and so is what drivers name and the mesh does not
 *   have: targets, joints, areas.
 */
export const addDrivers: AddDrivers = addDriversBy(BINDINGS)

/** The same with a renderer's ways to read inputs. */
export function addDriversBy(bindings: InputBindings): AddDrivers {
  return (wrinkles, drivers, options = {}) => {
    addMuscles(wrinkles.mesh, driversOf('muscle', drivers))
    bindDrivers(wrinkles, drivers, () => options, bindings).bind()
  }
}
