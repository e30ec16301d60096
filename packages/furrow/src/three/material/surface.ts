import type { Material, Mesh } from 'three'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** Returns the material that shows a mesh's wrinkles: the first with a normal map. three-vrm adds a second material for MToon outlines. */
export function surfaceOf(mesh: Mesh): Material {
  const materials = [mesh.material].flat()
  return materials.find(readsNormalMap) ?? materials[0]
}

/** Returns a mesh's `material` value with `surface` replaced by `other`. */
export function withSurface({ material }: Mesh, surface: Material, other: Material): Material | Material[] {
  return Array.isArray(material) ? material.map((each) => (each === surface ? other : each)) : other
}

/** Whether a material supports a normal map. A custom shader must mention `normalMap`. */
export function readsNormalMap(material: Material | undefined): material is WrinkleMaterial {
  if (!material || !('normalMap' in material)) return false
  const { fragmentShader } = material as WrinkleMaterial
  return fragmentShader === undefined || /\bnormalMap\b/.test(fragmentShader)
}
