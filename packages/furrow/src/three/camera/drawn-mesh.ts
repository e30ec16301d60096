import { type Mesh, type Object3D, type SkinnedMesh, Vector3 } from 'three'
import { trianglesOf } from '../sources/geometry-arrays.ts'

/** A mesh and its vertices in the current pose of its skeleton, with blendshape weights of 0. */
export interface DrawnMesh {
  mesh: Mesh
  /** Packed xyz positions, world space. */
  positions: Float64Array
  triangles: ArrayLike<number>
  /** Indices of the vertices that triangles use. A glTF primitive may use a small part of a vertex buffer that the whole file shares. */
  used: readonly number[]
}

/** Returns the meshes under an object in the current pose of their skeletons. World matrices must be up to date. */
export function drawnMeshes(object: Object3D): DrawnMesh[] {
  const meshes: DrawnMesh[] = []
  object.traverse((child) => {
    const mesh = child as Mesh
    if (mesh.isMesh && mesh.geometry.hasAttribute('position')) meshes.push(drawnMesh(mesh))
  })
  return meshes
}

function drawnMesh(mesh: Mesh): DrawnMesh {
  const { position } = mesh.geometry.attributes
  const triangles = trianglesOf(mesh.geometry)
  const isUsed = new Uint8Array(position.count)
  for (let i = 0; i < triangles.length; i++) isUsed[triangles[i]] = 1
  const positions = new Float64Array(3 * position.count)
  const used: number[] = []
  const point = new Vector3()
  for (let i = 0; i < position.count; i++) {
    if (isUsed[i] === 0) continue
    point.fromBufferAttribute(position, i)
    if ((mesh as Partial<SkinnedMesh>).isSkinnedMesh) (mesh as SkinnedMesh).applyBoneTransform(i, point)
    point.applyMatrix4(mesh.matrixWorld).toArray(positions, 3 * i)
    if (Number.isFinite(point.x + point.y + point.z)) used.push(i)
  }
  return { mesh, positions, triangles, used }
}
