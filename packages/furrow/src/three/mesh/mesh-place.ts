import type { Matrix4, Mesh, SkinnedMesh } from 'three'

/** World matrices of a mesh and the first bone of its skeleton at some time. */
export interface MeshPlace {
  mesh: Matrix4
  bone: Matrix4 | undefined
}

/** Records the place of a mesh when it is loaded: scaling the mesh later scales its wrinkles too. */
export function placeOf(mesh: Mesh): MeshPlace {
  const [bone] = (mesh as Partial<SkinnedMesh>).skeleton?.bones ?? []
  mesh.updateWorldMatrix(true, false)
  bone?.updateWorldMatrix(true, false)
  return { mesh: mesh.matrixWorld.clone(), bone: bone?.matrixWorld.clone() }
}
