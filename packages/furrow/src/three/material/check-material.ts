import { type Material, type Mesh, ObjectSpaceNormalMap } from 'three'
import { FurrowError } from '../../core/error.ts'
import { readsNormalMap, surfaceOf } from './surface.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

export const patchedMaterials = new WeakSet<Material>()

/**
 * Returns the material that will show the wrinkles of a mesh.
 *
 * @throws FurrowError if the material is unsupported, or already shows wrinkles.
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
    return { problem: 'object-space normal map', remedy: 'bake the normal map to tangent space' }
  }
  if (patchedMaterials.has(material)) {
    return {
      problem: 'the material already shows wrinkles',
      remedy: 'clone the material (mesh.material = mesh.material.clone()), or dispose of the other wrinkles',
    }
  }
  return null
}
