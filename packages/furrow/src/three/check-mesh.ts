import type { Mesh } from 'three'
import { FurrowError } from '../core/error.ts'
import { instancesOf } from './instances.ts'

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
    code: 'unsupported',
    who: 'Wrinkles',
    what: 'composed mode on instances, which share a normal map',
    value: mesh.name,
    limit: 'a mesh of its own',
    remedy: 'use the default mode',
  })
}
