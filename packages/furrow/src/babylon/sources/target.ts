import { targetSource } from '../../drivers/sources.ts'
import type { BindInputs } from './bind-plan.ts'
import { readWeights, targetNames } from './morph.ts'

/** Reads the weights of the mesh's morph targets. */
export const bindTargets: BindInputs<'target'> = ({ mesh }, inputs) => ({
  ...targetSource(inputs, targetNames(mesh.morphTargetManager)),
  read: (values) => readWeights(mesh, values),
})
