import type { InstancedMesh, Mesh } from 'three'

/** Reads blendshape weights in the order of their names. Runs in every frame, and allocates nothing. */
export type ReadWeights = (weights: Float64Array, instance: number) => void

/** Creates a reader of a mesh's blendshape weights, or of an instance's own weights (`setMorphAt`). */
export function weightReader(mesh: Mesh, { length }: readonly string[]): ReadWeights {
  return (values, instance) => {
    const { morphTargetInfluences, morphTexture } = mesh as Partial<InstancedMesh>
    if (morphTexture) {
      // One row per instance: the weight of the base shape, then the target weights.
      const { data, width } = morphTexture.image
      for (let i = 0; i < length; i++) values[i] = data![instance * width + 1 + i]
    } else if (morphTargetInfluences) for (let i = 0; i < length; i++) values[i] = morphTargetInfluences[i]
  }
}

/**
 * Names of a mesh's blendshapes in the order of the weights; unnamed blendshapes get their index. An `InstancedMesh` may have names only in
 * its geometry. The dictionary's key order is unreliable: keys may be numbers, and names may repeat.
 */
export function targetNames({ geometry, morphTargetDictionary }: Mesh): string[] {
  const targets = geometry.morphAttributes.position ?? []
  const names = targets.map(({ name }, i) => (morphTargetDictionary ? String(i) : name))
  for (const [name, i] of Object.entries(morphTargetDictionary ?? {})) names[i] = name
  return Array.from(names, (name, i) => name ?? String(i))
}
