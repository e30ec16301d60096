import { planDrivers } from '../../drivers/plan-drivers.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import type { DriverRuntime } from '../../runtime/driver-runtime.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'
import { bindPlan } from './bind-plan.ts'
import type { DriversOptions, InputBindings } from './binding.ts'
import { bindJoints } from './joint.ts'
import { bindTargets } from './target.ts'
import { bindTension } from './tension.ts'

/** How `furrow/three` reads each kind of input. */
export const BINDINGS = {
  target: bindTargets,
  joint: bindJoints,
  tension: bindTension,
} satisfies InputBindings

/** `bindPlan` for drivers of any type. */
export function bindDrivers(
  wrinkles: WrinklesBase,
  drivers: readonly WrinkleDriver[],
  optionsOf: () => DriversOptions,
  bindings: InputBindings,
): DriverRuntime<AnyRenderer> {
  return bindPlan(wrinkles, { drivers, plan: planDrivers(drivers), bindings }, optionsOf)
}
