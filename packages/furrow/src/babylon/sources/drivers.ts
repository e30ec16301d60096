import type { WrinkleDriver } from '../../drivers/registry.ts'
import { applyDrivers } from '../../runtime/apply-drivers.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'

/**
 * Adds drivers to those of a face (`wrinkles.drivers`). They activate areas before each frame, as long as `wrinkles.driven` is true, and
 * add to an area's activation at rest, up to 1. Muscles become morph targets of the face's meshes.
 *
 * @param drivers as in a file. Unknown types are left out with a warning, as are targets, joints and areas that do not exist.
 * @throws FurrowError when `wrinkles` is not a `Wrinkles` or was disposed of, or a driver is not as `parseDrivers` reads it; the face
 *   then keeps its drivers.
 */
export function addDrivers(wrinkles: WrinklesBase, drivers: readonly WrinkleDriver[]): void {
  checkWrinkles(wrinkles, 'addDrivers')
  applyDrivers(drivers, 'addDrivers', () => meshOf(wrinkles).drive([...wrinkles.drivers, ...drivers]))
}

/**
 * Replaces the drivers of a face. Joints that are no bones are measured from their present pose.
 *
 * @param drivers as for `addDrivers`; an empty list drives nothing.
 * @throws FurrowError as `addDrivers` does.
 */
export function setDrivers(wrinkles: WrinklesBase, drivers: readonly WrinkleDriver[]): void {
  checkWrinkles(wrinkles, 'setDrivers')
  applyDrivers(drivers, 'setDrivers', () => meshOf(wrinkles).drive(drivers))
}
