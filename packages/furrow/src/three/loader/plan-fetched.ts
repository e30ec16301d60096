import { morph } from '../../drivers/morph/definition.ts'
import { planBy } from '../../drivers/plan.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import type { PlannedDrivers } from '../sources/bind-plan.ts'
import type { BindInputs, FetchedBindings } from '../sources/binding.ts'
import { meshTargets } from '../sources/morph.ts'

/** Plans the drivers of a file, and fetches what these drivers need beyond blendshapes, which most files have alone. */
export async function planFetched(
  drivers: readonly WrinkleDriver[],
  { joint, tension }: FetchedBindings,
  isVrm: boolean,
): Promise<PlannedDrivers> {
  const isUsual = drivers.every(({ type }) => type === 'morph')
  const definitionOf = isUsual ? morphOnly : (await import('../../drivers/registry.ts')).definitionOf
  const plan = planBy(definitionOf, drivers)
  const { inputs } = plan
  return {
    drivers,
    plan,
    bindings: {
      target: isVrm ? (await import('../sources/target.ts')).bindTargets : meshTargetsOnly,
      ...(inputs.joint.length > 0 && { joint: await joint() }),
      ...(inputs.tension.length > 0 && { tension: await tension() }),
    },
  }
}

const morphOnly = () => morph as never

const meshTargetsOnly: BindInputs<'target'> = (wrinkles, inputs) => meshTargets(wrinkles, inputs)
