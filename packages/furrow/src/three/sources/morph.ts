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

/**
 * Names of a mesh's blendshapes in the order of the weights; the index of one that has none. An `InstancedMesh` may have them in its geometry
 * only. The dictionary alone does not tell the order: its keys may be numbers, and several blendshapes may have one name.
 */
export function targetNames({ geometry, morphTargetDictionary }: Mesh): string[] {
  const targets = geometry.morphAttributes.position ?? []
  const names = targets.map(({ name }, i) => (morphTargetDictionary ? String(i) : name))
  for (const [name, i] of Object.entries(morphTargetDictionary ?? {})) names[i] = name
  return Array.from(names, (name, i) => name ?? String(i))
}
