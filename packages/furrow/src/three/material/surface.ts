import type { Material, Mesh } from 'three'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/**
 * Returns the material of a mesh that shows wrinkles: the first material that supports a normal map. A mesh may have several materials, e.g.
 * because three-vrm adds a material for MToon outlines.
 */
export function surfaceOf(mesh: Mesh): Material {
  const materials = [mesh.material].flat()
  return materials.find(readsNormalMap) ?? materials[0]
}

/** Returns the value of `mesh.material`, with `other` in place of `surface`. */
export function withSurface({ material }: Mesh, surface: Material, other: Material): Material | Material[] {
  return Array.isArray(material) ? material.map((each) => (each === surface ? other : each)) : other
}

/** Whether a material supports a normal map. A custom shader does if its code contains `normalMap`. */
export function readsNormalMap(material: Material | undefined): material is WrinkleMaterial {
  if (!material || !('normalMap' in material)) return false
  const { fragmentShader } = material as WrinkleMaterial
  return fragmentShader === undefined || /\bnormalMap\b/.test(fragmentShader)
}
