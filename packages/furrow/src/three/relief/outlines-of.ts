import type { Material, Mesh } from 'three'

/**
 * Returns the materials that draw the outline of a surface: three-vrm adds them to the mesh's materials and groups for MToon
 * (`VRMC_materials_mtoon`).
 */
export function outlinesOf(mesh: Mesh, surface: Material): Material[] {
  const materials = [mesh.material].flat()
  const drawn = rangesOf(mesh, materials.indexOf(surface))
  return materials.filter(
    (material, i) => 'isOutline' in material && material.isOutline && rangesOf(mesh, i) === drawn,
  )
}

/** Key of the triangle ranges that use a material. */
function rangesOf({ geometry }: Mesh, index: number): string {
  const groups = geometry.groups.filter(({ materialIndex = 0 }) => materialIndex === index)
  return groups.map(({ start, count }) => `${start} ${count}`).join()
}
