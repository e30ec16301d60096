import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { InputOf } from '../../drivers/activation.ts'
import { targetSource } from '../../drivers/sources.ts'
import type { InputReader } from '../../runtime/driver-runtime.ts'
import { readWeights, targetNames } from './morph.ts'

/** Creates a reader for the weights of a mesh's morph targets. */
export function bindTargets(mesh: AbstractMesh, inputs: readonly InputOf<'target'>[]): InputReader<unknown> {
  return {
    ...targetSource(inputs, targetNames(mesh.morphTargetManager)),
    read: (values) => readWeights(mesh, values),
  }
}
