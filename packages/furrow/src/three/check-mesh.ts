import type { Mesh } from 'three'
import { FurrowError } from '../core/error.ts'
import { instancesOf } from './instances.ts'

/**
 * Checks that a mesh has positions, normals and UVs.
 *
 * @throws FurrowError when one is missing.
 */
export function checkMesh(mesh: Mesh): void {
  for (const [attribute, remedy] of [
    ['position', 'give the mesh its vertices first'],
    ['uv', 'unwrap the mesh: areas and layers are in its UV layout'],
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

/**
 * Checks that a mesh is not instanced, for modes in which all instances would show the same wrinkles.
 *
 * @throws FurrowError when it is.
 */
export function checkNotInstanced(mesh: Mesh, mode: string): void {
  if (!instancesOf(mesh)) return
  throw new FurrowError({
    who: 'Wrinkles.mode',
    what: 'instances cannot wrinkle independently in this mode',
    value: mode,
    limit: 'default or off for an InstancedMesh or BatchedMesh',
    remedy: 'use the default mode',
  })
}
