import type { BatchedMesh, InstancedMesh, Mesh } from 'three'

/** Kind of instanced mesh; null for a mesh that is not instanced. Each instance is a separate face. */
export type Instances = 'instanced' | 'batched' | null

export function instancesOf(mesh: Mesh): Instances {
  if ((mesh as Partial<InstancedMesh>).isInstancedMesh) return 'instanced'
  return (mesh as Partial<BatchedMesh>).isBatchedMesh ? 'batched' : null
}

/** Returns the number of faces that a mesh shows: its maximum instance count, or 1 if it is not instanced. */
export function countFaces(mesh: Mesh): number {
  const instances = instancesOf(mesh)
  if (!instances) return 1
  if (instances === 'instanced') return (mesh as InstancedMesh).count
  // Up to three.js r165, a batched mesh has one instance per geometry.
  const { maxInstanceCount, maxGeometryCount } = mesh as BatchedMesh & { maxGeometryCount?: number }
  return maxInstanceCount ?? maxGeometryCount!
}
