import { planBy } from '../../drivers/plan.ts'
import { definitionOf, type WrinkleDriver } from '../../drivers/registry.ts'
import { bindPlan } from '../sources/bind-plan.ts'
import { bindTargets } from '../sources/target.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'

/** Plans drivers of any type, and fetches what these read. */
export async function planDrivers(drivers: readonly WrinkleDriver[]): Promise<(own: WrinklesBase) => void> {
  const plan = planBy(definitionOf, drivers)
  const { inputs } = plan
  const bindings = {
    target: bindTargets,
    ...(inputs.tension.length > 0 && { tension: (await import('../sources/tension.ts')).bindTension }),
    ...(inputs.joint.length > 0 && { joint: (await import('../sources/joint.ts')).bindJoints }),
  }
  return (own) => bindPlan(own, { drivers, plan, bindings })
}
