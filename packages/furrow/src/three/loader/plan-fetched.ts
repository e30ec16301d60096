import { morph } from '../../drivers/morph/definition.ts'
import { planBy } from '../../drivers/plan.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import type { PlannedDrivers } from '../sources/bind-plan.ts'
import type { FetchedBindings } from '../sources/binding.ts'

/** Plans the drivers of a file, and fetches what these drivers need beyond blendshapes, which most files have alone. */
export async function planFetched(
  drivers: readonly WrinkleDriver[],
  { target, joint, tension }: FetchedBindings,
): Promise<PlannedDrivers> {
  const isUsual = drivers.every(({ type }) => type === 'morph')
  const { definitionOf } = isUsual ? MORPH_ONLY : await import('../../drivers/registry.ts')
  const plan = planBy(definitionOf, drivers)
  const { inputs } = plan
  return {
    drivers,
    plan,
    bindings: {
      target: await target(),
      ...(inputs.joint.length > 0 && { joint: await joint() }),
      ...(inputs.tension.length > 0 && { tension: await tension() }),
    },
  }
}

const MORPH_ONLY = { definitionOf: () => morph as never }
