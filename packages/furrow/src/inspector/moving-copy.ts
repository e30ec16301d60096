import type { Material, Mesh } from 'three'

/** Adds an invisible copy of a mesh. It moves with the mesh, because it shares the geometry, the joints and the blendshape weights. */
export function movingCopy(mesh: Mesh, material: Material): Mesh {
  const copy = mesh.clone(false)
  copy.material = material
  copy.morphTargetInfluences = mesh.morphTargetInfluences
  copy.visible = false
  mesh.parent?.add(copy)
  return copy
}
