import type { InstancedMesh, Mesh } from 'three'
import type { InputOf } from '../../drivers/activation.ts'
import type { VrmWeights } from '../../drivers/morph/vrm.ts'
import { targetSource } from '../../drivers/sources.ts'
import type { InputReader } from '../../runtime/driver-runtime.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'

/**
 * Reads the weights of the mesh's blendshapes; of instances, their own if they have any (`setMorphAt`).
 *
 * @param vrm weights that links may name like blendshapes.
 */
export function meshTargets(
  { mesh }: WrinklesBase,
  inputs: readonly InputOf<'target'>[],
  vrm?: VrmWeights,
): InputReader<unknown> {
  const own = targetNames(mesh)
  return {
    ...targetSource(inputs, vrm ? [...own, ...vrm.names] : own),
    read(values, instance) {
      const { morphTargetInfluences, morphTexture } = mesh as Partial<InstancedMesh>
      if (morphTexture) {
        // One row per instance: the weight of the base shape, then those of the targets.
        const { data, width } = morphTexture.image
        for (let i = 0; i < own.length; i++) values[i] = data![instance * width + 1 + i]
        return
      }
      if (morphTargetInfluences) for (let i = 0; i < own.length; i++) values[i] = morphTargetInfluences[i]
      vrm?.writeTo(values, own.length)
    },
  }
}

/** Names in the order of the weights. An `InstancedMesh` may have them in its geometry only. */
function targetNames({ geometry, morphTargetDictionary }: Mesh): string[] {
  if (!morphTargetDictionary) return geometry.morphAttributes.position?.map(({ name }) => name) ?? []
  return Object.keys(morphTargetDictionary)
}
