import { expressionsOf } from '../../drivers/expression/expression.ts'
import type { DriverPlan } from '../../drivers/plan.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { DriverRuntime } from '../../runtime/driver-runtime.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'
import type { DriversOptions, InputBindings } from './binding.ts'

/** Drivers in the order in which they run, and the ways to read their inputs: shared by all faces that have these drivers. */
export interface PlannedDrivers {
  drivers: readonly WrinkleDriver[]
  plan: DriverPlan
  /** At least those of the kinds of input that the plan has. */
  bindings: InputBindings
}

/**
 * Lets drivers activate areas. Their inputs are found on the mesh at the first frame, or by `bind` of the result. Muscles must have been
 * added to the mesh.
 *
 * @param optionsOf called then: a VRM's expressions may not exist before.
 */
export function bindPlan(
  wrinkles: WrinklesBase,
  { drivers, plan, bindings: { target, joint, tension } }: PlannedDrivers,
  optionsOf: () => DriversOptions,
): DriverRuntime<AnyRenderer> {
  const { inputs } = plan
  const runtime = new DriverRuntime(
    plan,
    () => {
      const options = optionsOf()
      return {
        ...(target && { target: target(wrinkles, inputs.target, options) }),
        ...(joint && { joint: joint(wrinkles, inputs.joint, options) }),
        ...(tension && { tension: tension(wrinkles, inputs.tension, options) }),
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
