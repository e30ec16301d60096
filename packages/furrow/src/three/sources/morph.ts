import type { InstancedMesh, Mesh } from 'three'

/** Copies the current blendshape weights of an instance into `weights`, in the order of `targetNames`. Must not allocate. */
export type ReadWeights = (weights: Float64Array, instance: number) => void

/** Creates a reader of a mesh's blendshape weights. If instances have individual weights (`InstancedMesh.setMorphAt`), reads these. */
export function weightReader(mesh: Mesh, { length }: readonly string[]): ReadWeights {
  return (values, instance) => {
    const { morphTargetInfluences, morphTexture } = mesh as Partial<InstancedMesh>
    if (morphTexture) {
      // The texture has one row per instance. A row holds the weight of the base shape, then the weights of the blendshapes.
      const { data, width } = morphTexture.image
      for (let i = 0; i < length; i++) values[i] = data![instance * width + 1 + i]
    } else if (morphTargetInfluences) for (let i = 0; i < length; i++) values[i] = morphTargetInfluences[i]
  }
}

/**
 * Returns the names of a mesh's blendshapes, by blendshape index. The name of an unnamed blendshape is its index. An `InstancedMesh` may have
 * names only in its geometry. The keys of `morphTargetDictionary` may be in another order, and lack repeated names.
 */
export function targetNames({ geometry, morphTargetDictionary }: Mesh): string[] {
  const targets = geometry.morphAttributes.position ?? []
  const names = targets.map(({ name }, i) => (morphTargetDictionary ? String(i) : name))
  for (const [name, i] of Object.entries(morphTargetDictionary ?? {})) names[i] = name
  return Array.from(names, (name, i) => name ?? String(i))
}
