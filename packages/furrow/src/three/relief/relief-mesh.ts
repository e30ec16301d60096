import { type BufferGeometry, InstancedMesh, type Material, Mesh, Object3D } from 'three'

/** Child of a mesh. It is drawn in place of the mesh, with smaller triangles, so that height maps can displace the surface. */
export type ReliefMesh = Mesh & { readonly isReliefMesh: true }

/** Creates the relief mesh for one material of a mesh. The caller adds it to the mesh. */
export function createReliefMesh(mesh: Mesh, geometry: BufferGeometry, material: Material): ReliefMesh {
  const { isInstancedMesh, count, instanceMatrix, instanceColor } = mesh as InstancedMesh
  const relief: Mesh = isInstancedMesh
    ? Object.assign(new InstancedMesh(geometry, material, 0), { count, instanceMatrix, instanceColor })
    : new Mesh(geometry, material)
  relief.name = `${mesh.name} relief`
  // Raycasts hit the original mesh.
  relief.raycast = () => {}
  // A clone of the original mesh creates its own relief mesh, so this one must not be cloned.
  relief.clone = () => new Object3D() as never
  // The bounds of the geometry would be wrong if bones scale quantised positions, because the relief mesh has no bones.
  Object.defineProperty(relief, 'boundingSphere', { get: () => boundingSphereOf(mesh) })
  Object.defineProperty(relief, 'boundingBox', { get: () => boundingBoxOf(mesh) })
  relief.getVertexPosition = (index, target) =>
    mesh.getVertexPosition(index % mesh.geometry.attributes.position.count, target)
  return Object.assign(relief, { isReliefMesh: true } as const)
}

/** Copies render settings of the original mesh, which the page may change in each frame. */
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
