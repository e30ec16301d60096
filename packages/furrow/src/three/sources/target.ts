import type { Mesh } from 'three'
import type { InputOf } from '../../drivers/activation.ts'
import type { Expression } from '../../drivers/expression/expression.ts'
import { type VrmExpressions, VrmWeights } from '../../drivers/morph/vrm.ts'
import { targetSource } from '../../drivers/sources.ts'
import type { InputReader } from '../../runtime/driver-runtime.ts'
import { type ReadWeights, targetNames, weightReader } from './morph.ts'

/** Names of blendshapes, and a reader of their weights. */
export interface MeshTargets {
  names: readonly string[]
  read: ReadWeights
}

/** Where the inputs of a face's drivers are found, besides the mesh itself. */
export interface InputOptions {
  /** Returns a VRM's expressions, which may not exist before the first frame. */
  expressions?: () => VrmExpressions | undefined
  /** The expressions of its file, by the blendshapes that they move. */
  vrmExpressions?: readonly Expression[]
  /** Blendshapes of a mesh; by default those that it has. */
  targetsOf?: (mesh: Mesh) => MeshTargets
}

/** Reads the weights of the mesh's blendshapes, and of a VRM's expressions if it has any. */
export function bindTargets(
  mesh: Mesh,
  inputs: readonly InputOf<'target'>[],
  { expressions, targetsOf = ownTargets }: InputOptions,
): InputReader<unknown> {
  const manager = expressions?.()
  const vrm = manager && new VrmWeights(manager)
  const { names, read } = targetsOf(mesh)
  return {
    ...targetSource(inputs, vrm ? [...names, ...vrm.names] : names),
    read(values, instance) {
      read(values, instance)
      vrm?.writeTo(values, names.length)
    },
  }
}

function ownTargets(mesh: Mesh): MeshTargets {
  const names = targetNames(mesh)
  return { names, read: weightReader(mesh, names) }
}
