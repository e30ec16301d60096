import { morph } from '../../drivers/morph/definition.ts'
import { planBy } from '../../drivers/plan.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import type { PlannedDrivers } from '../sources/bind-plan.ts'
import { bindTargets } from '../sources/target.ts'

/** Plans the drivers of a file, and fetches what these drivers need beyond morph targets, which most files have alone. */
export async function planFetched(drivers: readonly WrinkleDriver[]): Promise<PlannedDrivers> {
  const isUsual = drivers.every(({ type }) => type === 'morph')
  const definitionOf = isUsual
    ? () => morph as never
    : (await import('../../drivers/registry.ts')).definitionOf
  const plan = planBy(definitionOf, drivers)
  return {
    drivers,
    plan,
    bindings: {
      target: bindTargets,
      ...(plan.inputs.tension.length > 0 && {
        tension: (await import('../sources/tension.ts')).bindTension,
      }),
      ...(plan.inputs.joint.length > 0 && { joint: (await import('../sources/joint.ts')).bindJoints }),
    },
  }
}
