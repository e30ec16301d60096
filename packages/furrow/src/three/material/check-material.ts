import { type Material, type Mesh, ObjectSpaceNormalMap } from 'three'
import { FurrowError } from '../../core/error.ts'
import { readsNormalMap, surfaceOf } from './surface.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** Those that show wrinkles. */
export const patchedMaterials = new WeakSet<Material>()

/**
 * The material of a mesh that shows its wrinkles.
 *
 * @throws FurrowError, which names the mesh, when it cannot, or shows others already.
 */
export function checkMaterial(mesh: Mesh): WrinkleMaterial {
  const material = surfaceOf(mesh) as WrinkleMaterial
  const problem = problemOf(material)
  if (!problem) return material
  throw new FurrowError({ who: 'Wrinkles', value: mesh.name, ...problem })
}

function problemOf(material: WrinkleMaterial): { problem: string; remedy: string } | null {
  if (!readsNormalMap(material)) {
    return {
      problem: `material ${(material as Material | undefined)?.type} does not support normal maps`,
      remedy: 'use a lit material such as MeshStandardMaterial',
    }
  }
  if (material.normalMap && material.normalMapType === ObjectSpaceNormalMap) {
    return { problem: 'object-space normal map', remedy: 'bake it to tangent space' }
  }
  if (patchedMaterials.has(material)) {
    return {
      problem: 'the material already shows wrinkles',
      remedy: 'give the mesh its own: mesh.material = mesh.material.clone(), or dispose the other wrinkles',
    }
  }
  return null
}
