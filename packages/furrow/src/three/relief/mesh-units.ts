import { Matrix4, type Mesh, type SkinnedMesh } from 'three'
import type { MeshPlace } from '../mesh/mesh-place.ts'

/** Metres per unit of a mesh's positions, from the scale of the mesh and its bones in the file. */
export interface MeshUnits {
  /** Metres per unit of the positions in the geometry. */
  atRest: number
  /** Metres per unit of positions after skinning, in the mesh's local space. */
  deformed: number
}

/** Computes the units of a mesh from the world matrices that it had when it was loaded. */
export function meshUnits(mesh: Mesh, place: MeshPlace): MeshUnits {
  const deformed = scaleOf(place.mesh)
  if (!place.bone) return { atRest: deformed, deformed }
  const { skeleton, bindMatrix } = mesh as SkinnedMesh
  const bound = new Matrix4().multiplyMatrices(place.bone, skeleton.boneInverses[0]).multiply(bindMatrix)
  return { atRest: scaleOf(bound), deformed }
}

function scaleOf(matrix: Matrix4): number {
  const scale = matrix.getMaxScaleOnAxis()
  return scale > 0 && Number.isFinite(scale) ? scale : 1
}
