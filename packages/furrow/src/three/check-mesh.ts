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

/** Checks that a mesh is not instanced: in some modes all instances would show the same wrinkles. */
export function checkNotInstanced(mesh: Mesh, mode: string): void {
  if (!instancesOf(mesh)) return
  throw new FurrowError({
    who: 'Wrinkles.mode',
    what: 'instances cannot have wrinkles of their own in this mode',
    value: mode,
    limit: 'default or off for an InstancedMesh or BatchedMesh',
    remedy: 'use the default mode',
  })
}
