import type { WrinkleDriver } from '../../drivers/registry.ts'
import { applyDrivers } from '../../runtime/apply-drivers.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'

/**
 * Adds drivers to a face. They run before each frame while `wrinkles.driven` is true, and add to the resting activations, up to 1.
 * Muscles become morph targets of the face's meshes.
 *
 * @param drivers drivers as in a file. Unknown types, targets, joints and areas are skipped with a warning.
 * @throws FurrowError if `wrinkles` is invalid or disposed of, or `parseDrivers` rejects a driver; the drivers then stay unchanged.
 */
export function addDrivers(wrinkles: WrinklesBase, drivers: readonly WrinkleDriver[]): void {
  checkWrinkles(wrinkles, 'addDrivers')
  applyDrivers(drivers, 'addDrivers', () => meshOf(wrinkles).drive([...wrinkles.drivers, ...drivers]))
}

/**
 * Replaces the drivers of a face. The current pose becomes the rest pose of joints that are not bones.
 *
 * @param drivers drivers as for `addDrivers`; an empty list removes all.
 * @throws FurrowError as `addDrivers`.
 */
export function setDrivers(wrinkles: WrinklesBase, drivers: readonly WrinkleDriver[]): void {
  checkWrinkles(wrinkles, 'setDrivers')
  applyDrivers(drivers, 'setDrivers', () => meshOf(wrinkles).drive(drivers))
}
