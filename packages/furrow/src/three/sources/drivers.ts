import { checkOptionNames } from '../../core/nearest-name.ts'
import type { VrmExpressions } from '../../drivers/morph/vrm.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { applyDrivers } from '../../runtime/apply-drivers.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'

/** Options of `addDrivers` and `setDrivers`. */
export interface DriversOptions {
  /** A VRM's expressions (`vrm.expressionManager` of three-vrm), which links may name like blendshapes. Default: those known before. */
  expressions?: VrmExpressions
}

/**
 * Adds drivers to those of a face (`wrinkles.drivers`). They activate areas before each frame, as long as `wrinkles.driven` is true, and
 * add to an area's activation at rest, up to 1. Muscles become blendshapes of the mesh.
 *
 * @param drivers as in a file. Unknown types are left out with a warning, as are targets, joints and areas that do not exist.
 * @throws FurrowError when `wrinkles` is not a `Wrinkles` or was disposed of, or a driver is not as `parseDrivers` reads it; the face
 *   then keeps its drivers.
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
 * Replaces the drivers of a face. Tension is measured under the weights that areas have now, and joints that are no bones from their
 * present pose: `setDrivers(wrinkles, wrinkles.drivers)` updates both.
 *
 * @param drivers as for `addDrivers`; an empty list drives nothing.
 * @throws FurrowError as `addDrivers` does.
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
