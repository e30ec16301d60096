import type { Material, Mesh } from 'three'

/**
 * The materials that draw an outline round the part of a mesh that has another material: those of MToon (`VRMC_materials_mtoon`), which
 * three-vrm adds to the mesh's materials and groups.
 */
export function outlinesOf(mesh: Mesh, surface: Material): Material[] {
  const materials = [mesh.material].flat()
  const drawn = rangesOf(mesh, materials.indexOf(surface))
  return materials.filter((own, i) => 'isOutline' in own && own.isOutline && rangesOf(mesh, i) === drawn)
}

/** Which of a mesh's triangles have one of its materials. */
function rangesOf({ geometry }: Mesh, index: number): string {
  const own = geometry.groups.filter(({ materialIndex = 0 }) => materialIndex === index)
  return own.map(({ start, count }) => `${start} ${count}`).join()
}
