import { Matrix4, type Mesh, type SkinnedMesh } from 'three'

/** Metres per unit of a mesh's positions, by the nodes of the file that it is in. */
export interface MeshUnits {
  /** Of the positions as stored. */
  atRest: number
  /** Of the positions in the mesh's local space after skinning. */
  deformed: number
}

/** Finds the units of a mesh. To be called when it has been loaded: what scales it later scales its wrinkles too. */
export function meshUnits(mesh: Mesh): MeshUnits {
  mesh.updateWorldMatrix(true, false)
  const deformed = scaleOf(mesh.matrixWorld)
  const { skeleton, bindMatrix } = mesh as Partial<SkinnedMesh>
  const [bone] = skeleton?.bones ?? []
  if (!bone) return { atRest: deformed, deformed }
  bone.updateWorldMatrix(true, false)
  const bound = new Matrix4()
    .multiplyMatrices(bone.matrixWorld, skeleton!.boneInverses[0])
    .multiply(bindMatrix!)
  return { atRest: scaleOf(bound), deformed }
}

function scaleOf(matrix: Matrix4): number {
  const scale = matrix.getMaxScaleOnAxis()
  return scale > 0 && Number.isFinite(scale) ? scale : 1
}
