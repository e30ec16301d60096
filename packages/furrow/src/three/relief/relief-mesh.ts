import { type BufferGeometry, InstancedMesh, type Material, Mesh, Object3D } from 'three'

/** Mesh with the dense geometry, drawn in place of its parent, whose render settings it copies. */
export type ReliefMesh = Mesh & { readonly isReliefMesh: true }

/** Creates the relief mesh for one material of a mesh, without adding it as a child. */
export function createReliefMesh(mesh: Mesh, geometry: BufferGeometry, material: Material): ReliefMesh {
  const { isInstancedMesh, count, instanceMatrix, instanceColor } = mesh as InstancedMesh
  const relief: Mesh = isInstancedMesh
    ? Object.assign(new InstancedMesh(geometry, material, 0), { count, instanceMatrix, instanceColor })
    : new Mesh(geometry, material)
  relief.name = `${mesh.name} relief`
  // Raycasts and bounds use the user's mesh.
  relief.raycast = () => {}
  // Clones of the mesh get their own relief.
  relief.clone = () => new Object3D() as never
  // Bones may scale quantised positions, and the relief has no bones.
  Object.defineProperty(relief, 'boundingSphere', { get: () => boundingSphereOf(mesh) })
  Object.defineProperty(relief, 'boundingBox', { get: () => boundingBoxOf(mesh) })
  relief.getVertexPosition = (index, target) =>
    mesh.getVertexPosition(index % mesh.geometry.attributes.position.count, target)
  return Object.assign(relief, { isReliefMesh: true } as const)
}

/** Copies the render settings of the mesh. */
export function followMesh(relief: ReliefMesh, mesh: Mesh): void {
  relief.castShadow = mesh.castShadow
  relief.receiveShadow = mesh.receiveShadow
  relief.renderOrder = mesh.renderOrder
  relief.frustumCulled = mesh.frustumCulled
  relief.layers.mask = mesh.layers.mask
  if ('count' in relief) Object.assign(relief, { count: (mesh as InstancedMesh).count })
}

function boundingSphereOf(mesh: Mesh) {
  const instanced = mesh as Partial<InstancedMesh>
  if (instanced.boundingSphere !== undefined) {
    if (instanced.boundingSphere === null) instanced.computeBoundingSphere!()
    return instanced.boundingSphere
  }
  if (mesh.geometry.boundingSphere === null) mesh.geometry.computeBoundingSphere()
  return mesh.geometry.boundingSphere
}

function boundingBoxOf(mesh: Mesh) {
  const instanced = mesh as Partial<InstancedMesh>
  if (instanced.boundingBox !== undefined) {
    if (instanced.boundingBox === null) instanced.computeBoundingBox!()
    return instanced.boundingBox
  }
  if (mesh.geometry.boundingBox === null) mesh.geometry.computeBoundingBox()
  return mesh.geometry.boundingBox
}
