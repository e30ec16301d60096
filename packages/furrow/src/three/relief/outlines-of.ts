import type { Material, Mesh } from 'three'

/**
 * Returns the materials of a mesh that draw the outline of a surface. For MToon (`VRMC_materials_mtoon`), three-vrm adds an outline material to
 * the mesh, and a geometry group with the same triangles as the surface.
 */
export function outlinesOf(mesh: Mesh, surface: Material): Material[] {
  const materials = [mesh.material].flat()
  const drawn = rangesOf(mesh, materials.indexOf(surface))
  return materials.filter(
    (material, i) => 'isOutline' in material && material.isOutline && rangesOf(mesh, i) === drawn,
  )
}

function rangesOf({ geometry }: Mesh, index: number): string {
  const groups = geometry.groups.filter(({ materialIndex = 0 }) => materialIndex === index)
  return groups.map(({ start, count }) => `${start} ${count}`).join()
}
