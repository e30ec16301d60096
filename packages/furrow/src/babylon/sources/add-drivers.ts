import { wrongArgument } from '../../core/argument.ts'
import { FurrowError } from '../../core/error.ts'
import { driversOf } from '../../drivers/of-type.ts'
import { planDrivers } from '../../drivers/plan-drivers.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'
import { bindPlan, type InputBindings } from './bind-plan.ts'
import { bindJoints } from './joint.ts'
import { addMuscles } from './muscles.ts'
import { bindTargets } from './target.ts'
import { bindTension } from './tension.ts'

const BINDINGS: InputBindings = { target: bindTargets, joint: bindJoints, tension: bindTension }

/**
 * Lets drivers activate areas before each frame, as long as `wrinkles.driven` is true and the wrinkles are not disposed of. They add to
 * an area's activation at rest, up to 1. Muscles become morph targets of the mesh. Drivers that were added before are replaced, and `wrinkles.expressions` with them.
 *
 * @param drivers as in a file. Unknown types are left out with a warning, as are targets, joints and areas that do not exist.
 * @throws FurrowError when `wrinkles` is not a `Wrinkles` or was disposed of, or a driver is not as `parseDrivers` reads it.
 */
export function addDrivers(wrinkles: WrinklesBase, drivers: readonly WrinkleDriver[]): void {
  checkWrinkles(wrinkles, 'addDrivers')
  if (!Array.isArray(drivers) || !drivers.every((driver) => typeof driver?.type === 'string')) {
    throw wrongArgument('addDrivers', 'drivers', drivers, 'a list of objects with a type')
  }
  try {
    addMuscles(wrinkles.mesh, driversOf('muscle', drivers))
    bindPlan(wrinkles, { drivers, plan: planDrivers(drivers), bindings: BINDINGS })
  } catch (error) {
    if (!(error instanceof TypeError)) throw error
    throw new FurrowError(
      {
        who: 'addDrivers',
        what: 'a driver lacks fields, or they have the wrong type',
        value: drivers.map(({ type }) => type).join(', '),
        remedy: 'read them by parseDrivers, which fills in defaults and says what is wrong',
      },
      { cause: error },
    )
  }
}
