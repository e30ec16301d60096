import type { BatchedMesh, InstancedMesh, Mesh } from 'three'

/** Kind of instanced mesh, with one face per instance; null for a single face. */
export type Instances = 'instanced' | 'batched' | null

/** Returns the kind of instancing of a mesh, or null. */
export function instancesOf(mesh: Mesh): Instances {
  if ((mesh as Partial<InstancedMesh>).isInstancedMesh) return 'instanced'
  return (mesh as Partial<BatchedMesh>).isBatchedMesh ? 'batched' : null
}

/** Number of faces: maximum instance count, or 1 for a plain mesh. */
export function countFaces(mesh: Mesh): number {
  const instances = instancesOf(mesh)
  if (!instances) return 1
  if (instances === 'instanced') return (mesh as InstancedMesh).count
  // Up to three.js r165 each geometry of a batch is one instance.
  const { maxInstanceCount, maxGeometryCount } = mesh as BatchedMesh & { maxGeometryCount?: number }
  return maxInstanceCount ?? maxGeometryCount!
}
