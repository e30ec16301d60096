import type { WrinkleDriver } from '../../drivers/registry.ts'
import { applyDrivers } from '../../runtime/apply-drivers.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'

/**
 * Adds drivers to a face. Before each frame, their values are added to the resting activations, and the sums are clamped to 1. Drivers run
 * while `wrinkles.driven` is true.
 * Drivers of type `muscle` also add morph targets to the face's meshes.
 *
 * @param drivers drivers in the format of a file. Unknown types, morph targets, joints and areas are skipped with a warning.
 * @throws FurrowError if `wrinkles` is invalid or has been disposed, or if `parseDrivers` rejects a driver. The face then keeps its drivers.
 */
export function addDrivers(wrinkles: WrinklesBase, drivers: readonly WrinkleDriver[]): void {
  checkWrinkles(wrinkles, 'addDrivers')
  applyDrivers(drivers, 'addDrivers', () => meshOf(wrinkles).drive([...wrinkles.drivers, ...drivers]))
}

/**
 * Replaces all drivers of a face. If a joint is not a bone of the mesh, its current pose becomes its rest pose.
 *
 * @param drivers drivers in the format of a file. An empty list removes all drivers.
 * @throws FurrowError for the same reasons as `addDrivers`.
 */
export function setDrivers(wrinkles: WrinklesBase, drivers: readonly WrinkleDriver[]): void {
  checkWrinkles(wrinkles, 'setDrivers')
  applyDrivers(drivers, 'setDrivers', () => meshOf(wrinkles).drive(drivers))
}
