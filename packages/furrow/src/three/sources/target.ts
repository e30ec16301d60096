import { VrmWeights } from '../../drivers/morph/vrm.ts'
import { targetSource } from '../../drivers/sources.ts'
import type { BindInputs } from './binding.ts'
import { targetNames, weightReader } from './morph.ts'

/** Reads the weights of the mesh's blendshapes, and of a VRM's expressions if it has any. */
export const bindTargets: BindInputs<'target'> = ({ mesh }, inputs, { expressions }) => {
  const vrm = expressions && new VrmWeights(expressions)
  const own = targetNames(mesh)
  const read = weightReader(mesh, own)
  return {
    ...targetSource(inputs, vrm ? [...own, ...vrm.names] : own),
    read(values, instance) {
      read(values, instance)
      vrm?.writeTo(values, own.length)
    },
  }
}
