import type { Material, Mesh } from 'three'

/** Adds an invisible copy of a mesh. The copy shares geometry, joints and blendshape weights, so it moves with the mesh. */
export function movingCopy(mesh: Mesh, material: Material): Mesh {
  const copy = mesh.clone(false)
  copy.material = material
  copy.morphTargetInfluences = mesh.morphTargetInfluences
  copy.visible = false
  mesh.parent?.add(copy)
  return copy
}
