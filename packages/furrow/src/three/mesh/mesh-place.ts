import type { Matrix4, Mesh, SkinnedMesh } from 'three'

/** Copies of the world matrices of a mesh, and of the first bone of its skeleton. */
export interface MeshPlace {
  mesh: Matrix4
  bone: Matrix4 | undefined
}

/**
 * Copies the current world matrices of a mesh. Relief uses the matrices at loading time to convert metres to units of the mesh. If the page
 * scales the mesh later, the wrinkles scale with it.
 */
export function placeOf(mesh: Mesh): MeshPlace {
  const [bone] = (mesh as Partial<SkinnedMesh>).skeleton?.bones ?? []
  mesh.updateWorldMatrix(true, false)
  bone?.updateWorldMatrix(true, false)
  return { mesh: mesh.matrixWorld.clone(), bone: bone?.matrixWorld.clone() }
}
