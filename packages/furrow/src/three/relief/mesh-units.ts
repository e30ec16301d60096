import { Matrix4, type Mesh, type SkinnedMesh } from 'three'
import type { MeshPlace } from '../mesh/mesh-place.ts'

/** Metres per unit of a mesh's positions, by the nodes of the file that it is in. */
export interface MeshUnits {
  /** Of the positions as stored. */
  atRest: number
  /** Of the positions in the mesh's local space after skinning. */
  deformed: number
}

/** The units of a mesh, from where it was when it had been loaded. */
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
