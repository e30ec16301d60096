import type { Material, Mesh } from 'three'

/** Adds a copy of a mesh that shares its geometry, joints and blendshape weights, and so moves with it. Hidden by default. */
export function movingCopy(mesh: Mesh, material: Material): Mesh {
  const copy = mesh.clone(false)
  copy.material = material
  copy.morphTargetInfluences = mesh.morphTargetInfluences
  copy.visible = false
  mesh.parent?.add(copy)
  return copy
}
