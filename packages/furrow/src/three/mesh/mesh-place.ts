import type { Matrix4, Mesh, SkinnedMesh } from 'three'

/** Where a mesh, and the first bone of its skeleton if it has one, were at some time. */
export interface MeshPlace {
  mesh: Matrix4
  bone: Matrix4 | undefined
}

/** Notes where a mesh is. To be called when it has been loaded: what scales it later scales its wrinkles too. */
export function placeOf(mesh: Mesh): MeshPlace {
  const [bone] = (mesh as Partial<SkinnedMesh>).skeleton?.bones ?? []
  mesh.updateWorldMatrix(true, false)
  bone?.updateWorldMatrix(true, false)
  return { mesh: mesh.matrixWorld.clone(), bone: bone?.matrixWorld.clone() }
}
