import { checkOptionNames } from '../../core/nearest-name.ts'
import type { VrmExpressions } from '../../drivers/morph/vrm.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { applyDrivers } from '../../runtime/apply-drivers.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'

/** Options of `addDrivers` and `setDrivers`. */
export interface DriversOptions {
  /**
   * Expressions of a VRM (three-vrm's `vrm.expressionManager`). Drivers can read the weights of expressions by name, like blendshape weights.
   * Default: the expressions from the last call.
   */
  expressions?: VrmExpressions
}

/**
 * Adds drivers to a face. Drivers compute activations from blendshapes, joints and other inputs. They run before each frame while
 * `wrinkles.driven` is true, and add to the resting activations, up to 1. Drivers of type `muscle` add blendshapes to the mesh.
 *
 * @param drivers drivers as in a file. Unknown types, blendshapes, joints and areas are skipped with a warning.
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
 * Replaces the drivers of a face. Tension drivers read the area weights only when drivers are set or added. If a joint is not a bone of the
 * mesh, its current pose becomes its rest pose. To update only area weights and rest poses, call `setDrivers(wrinkles, wrinkles.drivers)`.
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
