import { type Material, type Mesh, ObjectSpaceNormalMap } from 'three'
import { FurrowError } from '../core/error.ts'
import { instancesOf } from './instances.ts'
import type { WrinkleMaterial } from './renderer-parts.ts'

/** Checks that a mesh has what wrinkles need: positions, normals and UVs. */
export function checkMesh(mesh: Mesh): void {
  for (const [attribute, remedy] of [
    ['position', 'give the mesh its vertices first'],
    ['uv', 'unwrap the mesh: wrinkles lie in its UV layout'],
    ['normal', 'call geometry.computeVertexNormals() first'],
  ] as const) {
    if (mesh?.geometry?.hasAttribute(attribute)) continue
    throw new FurrowError({
      who: 'Wrinkles',
      what: `mesh without ${attribute}`,
      value: mesh?.name ?? mesh,
      limit: 'a mesh with positions, normals and UVs',
      remedy,
    })
  }
}

/** Checks that a mesh has one normal map to compose: instances share it. */
export function checkNotInstanced(mesh: Mesh): void {
  if (!instancesOf(mesh)) return
  throw new FurrowError({
    who: 'Wrinkles',
    what: 'composed mode on instances, which share a normal map',
    value: mesh.name,
    limit: 'a mesh of its own',
    remedy: 'use the default mode',
  })
}

/**
 * The material of a mesh, if it can be patched.
 *
 * @param isTaken whether other wrinkles are on a material already.
 */
export function checkMaterial(mesh: Mesh, isTaken: (material: Material) => boolean): WrinkleMaterial {
  const material = mesh.material as WrinkleMaterial
  const problem = materialProblem(material, isTaken)
  if (!problem) return material
  throw new FurrowError({ who: 'Wrinkles', value: mesh.name, ...problem })
}

function materialProblem(
  material: WrinkleMaterial,
  isTaken: (material: Material) => boolean,
): { what: string; remedy: string } | null {
  if (Array.isArray(material)) {
    return { what: 'mesh with several materials', remedy: 'split the mesh, one material each' }
  }
  if (!('normalMap' in material)) {
    return {
      what: `material ${(material as Material)?.type} has no normal map`,
      remedy: 'use a lit material such as MeshStandardMaterial',
    }
  }
  if (material.normalMap && material.normalMapType === ObjectSpaceNormalMap) {
    return { what: 'object-space normal map', remedy: 'bake it to tangent space' }
  }
  if (isTaken(material)) {
    return {
      what: 'material already carries wrinkles',
      remedy: 'give the mesh its own: mesh.material = mesh.material.clone(), or dispose the other wrinkles',
    }
  }
  return null
}
