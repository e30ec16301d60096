import type { Mesh } from 'three'
import type { InputOf } from '../../drivers/activation.ts'
import type { Expression } from '../../drivers/expression/expression.ts'
import { type VrmExpressions, VrmWeights } from '../../drivers/morph/vrm.ts'
import { targetSource } from '../../drivers/sources.ts'
import type { InputReader } from '../../runtime/driver-runtime.ts'
import { type ReadWeights, targetNames, weightReader } from './morph.ts'

/** Blendshape names with a reader of their weights. */
export interface MeshTargets {
  names: readonly string[]
  read: ReadWeights
}

/** Sources of a face's driver inputs, besides its mesh. */
export interface InputOptions {
  /** Returns the expressions of a VRM, which may not exist before the first frame. */
  expressions?: () => VrmExpressions | undefined
  /** Expressions of the VRM file, as blendshape weights. */
  vrmExpressions?: readonly Expression[]
  /** Returns the blendshapes of a mesh. Default: the mesh's own. */
  targetsOf?: (mesh: Mesh) => MeshTargets
}

/** Binds inputs to the mesh's blendshapes, and to VRM expressions if there are any. */
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
