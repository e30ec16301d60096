import { checkOptionNames } from '../../core/nearest-name.ts'
import type { VrmExpressions } from '../../drivers/morph/vrm.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { applyDrivers } from '../../runtime/apply-drivers.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'

/** Options of `addDrivers` and `setDrivers`. */
export interface DriversOptions {
  /** Expressions of a VRM (three-vrm's `vrm.expressionManager`) that links can name like blendshapes. Default: the current ones. */
  expressions?: VrmExpressions
}

/**
 * Adds drivers to a face. They run before each frame while `wrinkles.driven` is true, and add to the resting activations, up to 1.
 * Muscles become blendshapes of the mesh.
 *
 * @param drivers drivers as in a file. Unknown types, targets, joints and areas are skipped with a warning.
 * @throws FurrowError if `wrinkles` is invalid or disposed of, or `parseDrivers` rejects a driver; the drivers then stay unchanged.
 */
export function addDrivers(
  wrinkles: WrinklesBase,
  drivers: readonly WrinkleDriver[],
  options?: DriversOptions,
): void {
  checkWrinkles(wrinkles, 'addDrivers')
  applyDrivers(drivers, 'addDrivers', () =>
    meshOf(wrinkles).drive([...wrinkles.drivers, ...drivers], inputOptions(options, 'addDrivers')),
  )
}

/**
 * Replaces the drivers of a face. Also samples the areas' weights for tension, and the rest pose of joints that are not bones of the
 * mesh: `setDrivers(wrinkles, wrinkles.drivers)` updates both.
 *
 * @param drivers drivers as for `addDrivers`; an empty list removes all.
 * @throws FurrowError as `addDrivers`.
 */
export function setDrivers(
  wrinkles: WrinklesBase,
  drivers: readonly WrinkleDriver[],
  options?: DriversOptions,
): void {
  checkWrinkles(wrinkles, 'setDrivers')
  applyDrivers(drivers, 'setDrivers', () =>
    meshOf(wrinkles).drive(drivers, inputOptions(options, 'setDrivers')),
  )
}

function inputOptions(options: DriversOptions | undefined, who: string) {
  checkOptionNames(options ?? {}, ['expressions'], who)
  const { expressions } = options ?? {}
  return expressions && { expressions: () => expressions }
}
