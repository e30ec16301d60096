import type { BatchedMesh, InstancedMesh, Mesh } from 'three'

/** The kind of mesh, if it has instances, each of which wrinkles independently; null if it is one face. */
export type Instances = 'instanced' | 'batched' | null

/** Whether a mesh has instances, and of which kind. */
export function instancesOf(mesh: Mesh): Instances {
  if ((mesh as Partial<InstancedMesh>).isInstancedMesh) return 'instanced'
  return (mesh as Partial<BatchedMesh>).isBatchedMesh ? 'batched' : null
}

/** Number of faces: instances that a mesh may have, 1 for any other mesh. */
export function countFaces(mesh: Mesh): number {
  const instances = instancesOf(mesh)
  if (!instances) return 1
  if (instances === 'instanced') return (mesh as InstancedMesh).count
  // Until r165 of three.js each geometry of a batch is one instance.
  const { maxInstanceCount, maxGeometryCount } = mesh as BatchedMesh & { maxGeometryCount?: number }
  return maxInstanceCount ?? maxGeometryCount!
}
