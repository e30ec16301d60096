import { expressionsOf } from '../../drivers/expression/expression.ts'
import { planDrivers } from '../../drivers/plan.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { DriverRuntime } from '../../runtime/driver-runtime.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'
import type { DriversOptions, InputBindings } from './binding.ts'
import { bindJoints } from './joint.ts'
import { bindTargetWeights } from './morph.ts'
import { bindTension } from './tension.ts'

/** Lets the drivers of a file activate areas. */
export type AddDrivers = (
  wrinkles: WrinklesBase,
  drivers: readonly WrinkleDriver[],
  options?: DriversOptions,
) => void

/** How `furrow/three` reads each kind of input. */
export const BINDINGS: InputBindings = {
  target: bindTargetWeights,
  joint: bindJoints,
  tension: bindTension,
}

/**
 * Lets drivers activate areas before each frame, as long as `wrinkles.driven` is true and the wrinkles are not disposed of. Per
 * area they add to the activation at rest, to at most 1. Drivers that were added before are replaced.
 *
 * @param drivers types that nobody here knows are left out with a warning, and so is what drivers name and the mesh does not
 *   have: targets, joints, areas.
 */
export const addDrivers: AddDrivers = (wrinkles, drivers, options = {}) => {
  bindDrivers(wrinkles, drivers, () => options, BINDINGS).bind()
}

/**
 * The same with a renderer's own ways to read inputs. These are found on the mesh when the first frame begins, or by `bind` of
 * the result.
 *
 * @param optionsOf called then, since a VRM's expressions may not exist before.
 */
export function bindDrivers(
  wrinkles: WrinklesBase,
  drivers: readonly WrinkleDriver[],
  optionsOf: () => DriversOptions,
  { target, joint, tension }: InputBindings,
): DriverRuntime<AnyRenderer> {
  const plan = planDrivers(drivers)
  const runtime = new DriverRuntime(
    plan,
    () => {
      const options = optionsOf()
      return {
        target: target(wrinkles, plan.inputs.target, drivers, options),
        joint: joint(wrinkles, plan.inputs.joint, drivers, options),
        tension: tension(wrinkles, plan.inputs.tension, drivers, options),
      }
    },
    wrinkles.inputs,
    wrinkles.faceCount,
    wrinkles.mesh.name,
  )
  wrinkles.expressions = expressionsOf(drivers)
  wrinkles.setDrivers(runtime)
  return runtime
}
