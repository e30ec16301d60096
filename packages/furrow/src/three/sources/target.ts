import { VrmWeights } from '../../drivers/morph/vrm.ts'
import type { BindInputs } from './binding.ts'
import { meshTargets } from './morph.ts'

/** Reads the weights of the mesh's blendshapes, and of a VRM's expressions if it has any. */
export const bindTargets: BindInputs<'target'> = (wrinkles, inputs, { expressions }) =>
  meshTargets(wrinkles, inputs, expressions && new VrmWeights(expressions))
