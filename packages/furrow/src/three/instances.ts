import type { BatchedMesh, InstancedMesh, Mesh } from 'three'

/** How a mesh tells its instances apart, each of which has wrinkles of its own; null where it is one face. */
export type Instances = 'instanced' | 'batched' | null

export function instancesOf(mesh: Mesh): Instances {
  if ((mesh as Partial<InstancedMesh>).isInstancedMesh) return 'instanced'
  return (mesh as Partial<BatchedMesh>).isBatchedMesh ? 'batched' : null
}

/** How many faces a mesh has room for. */
export function countFaces(mesh: Mesh): number {
  const instances = instancesOf(mesh)
  if (!instances) return 1
  return instances === 'instanced' ? (mesh as InstancedMesh).count : (mesh as BatchedMesh).maxInstanceCount
}
