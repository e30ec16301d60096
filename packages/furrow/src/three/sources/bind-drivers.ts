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

/** How `furrow/three` reads each kind of input. */
export const BINDINGS: InputBindings = {
  target: bindTargetWeights,
  joint: bindJoints,
  tension: bindTension,
}

/**
 * Lets drivers activate areas, with a renderer's ways to read inputs. These are found on the mesh at the first frame, or by `bind` of
 * the result. Muscles must have been added to the mesh.
 *
 * @param optionsOf called then: a VRM's expressions may not exist before.
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
        target: target(wrinkles, plan.inputs.target, options),
        joint: joint(wrinkles, plan.inputs.joint, options),
        tension: tension(wrinkles, plan.inputs.tension, options),
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
