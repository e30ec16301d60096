import type { Material, Mesh } from 'three'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** The material of a mesh that shows its wrinkles: of several, as three-vrm has them for MToon's outlines, the first with a normal map. */
export function surfaceOf(mesh: Mesh): Material {
  const materials = [mesh.material].flat()
  return materials.find(readsNormalMap) ?? materials[0]
}

/** What a mesh has as its material, with another one in place of that which shows its wrinkles. */
export function withSurface({ material }: Mesh, surface: Material, other: Material): Material | Material[] {
  return Array.isArray(material) ? material.map((own) => (own === surface ? other : own)) : other
}

/** Whether a material has a normal map, or may be given one. A shader of its own must name it. */
export function readsNormalMap(material: Material | undefined): material is WrinkleMaterial {
  if (!material || !('normalMap' in material)) return false
  const { fragmentShader } = material as WrinkleMaterial
  return fragmentShader === undefined || /\bnormalMap\b/.test(fragmentShader)
}
