import type { Mesh } from 'three'
import type { InputOf } from '../../drivers/activation.ts'
import type { Expression } from '../../drivers/expression/expression.ts'
import { type VrmExpressions, VrmWeights } from '../../drivers/morph/vrm.ts'
import { targetSource } from '../../drivers/sources.ts'
import type { InputReader } from '../../runtime/driver-runtime.ts'
import { type ReadWeights, targetNames, weightReader } from './morph.ts'

export interface MeshTargets {
  names: readonly string[]
  read: ReadWeights
}

/** Sources of driver inputs in addition to the mesh of the face. */
export interface InputOptions {
  /** Returns the expressions of a VRM. Called when inputs are bound, because three-vrm may create the expressions late. */
  expressions?: () => VrmExpressions | undefined
  /** Expressions of the VRM file, converted to blendshape weights. */
  vrmExpressions?: readonly Expression[]
  /** Returns the blendshape names that drivers can use for a mesh. Default: the names of its morph targets. */
  targetsOf?: (mesh: Mesh) => MeshTargets
}

/** Creates a reader of the inputs that are weights: blendshapes of the mesh, and VRM expressions if there are any. */
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
