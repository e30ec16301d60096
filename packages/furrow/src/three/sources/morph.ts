import type { InstancedMesh, Mesh } from 'three'

/** Reads the weights of a mesh's blendshapes, in the order of their names. It runs in every frame, and allocates nothing. */
export type ReadWeights = (weights: Float64Array, instance: number) => void

/** Reads the weights of a mesh's blendshapes; of instances, their own if they have any (`setMorphAt`). */
export function weightReader(mesh: Mesh, { length }: readonly string[]): ReadWeights {
  return (values, instance) => {
    const { morphTargetInfluences, morphTexture } = mesh as Partial<InstancedMesh>
    if (morphTexture) {
      // One row per instance: the weight of the base shape, then those of the targets.
      const { data, width } = morphTexture.image
      for (let i = 0; i < length; i++) values[i] = data![instance * width + 1 + i]
    } else if (morphTargetInfluences) for (let i = 0; i < length; i++) values[i] = morphTargetInfluences[i]
  }
}

/** Names of a mesh's blendshapes in the order of the weights. An `InstancedMesh` may have them in its geometry only. */
export function targetNames({ geometry, morphTargetDictionary }: Mesh): string[] {
  if (!morphTargetDictionary) return geometry.morphAttributes.position?.map(({ name }) => name) ?? []
  return Object.keys(morphTargetDictionary)
}
