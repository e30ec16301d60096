import type { Mesh } from 'three'
import { VrmWeights } from '../../drivers/morph/vrm.ts'
import { targetSource } from '../../drivers/sources.ts'
import type { ReadWeights } from '../../runtime/morph-drivers.ts'
import type { BindInputs } from './binding.ts'
import { targetNames, weightReader } from './morph.ts'

/** Names of blendshapes, and what reads their weights from a mesh. */
export interface MeshTargets {
  names: readonly string[]
  read: ReadWeights
}

/** Reads the weights of the mesh's blendshapes, and of a VRM's expressions if it has any. */
export const bindTargets = bindTargetsBy((mesh) => {
  const names = targetNames(mesh)
  return { names, read: weightReader(mesh, names) }
})

/** The same where a mesh's blendshapes are known in another way. */
export function bindTargetsBy(targetsOf: (mesh: Mesh) => MeshTargets): BindInputs<'target'> {
  return ({ mesh }, inputs, { expressions }) => {
    const vrm = expressions && new VrmWeights(expressions)
    const { names, read } = targetsOf(mesh)
    return {
      ...targetSource(inputs, vrm ? [...names, ...vrm.names] : names),
      read(values, instance) {
        read(values, instance)
        vrm?.writeTo(values, names.length)
      },
    }
  }
}
