import type { Mesh } from 'three'
import { wrongArgument } from '../../core/argument.ts'
import { FurrowError } from '../../core/error.ts'
import { instancesOf } from './instances.ts'

/**
 * Checks that a mesh has positions, normals and UVs.
 *
 * @throws FurrowError if an attribute is missing, or the value is not a mesh.
 */
export function checkMesh(mesh: Mesh): void {
  checkIsMesh(mesh, 'Wrinkles')
  for (const [attribute, remedy] of [
    ['position', 'add positions first'],
    ['uv', 'unwrap the mesh: areas and layers use its UV layout'],
    ['normal', 'call geometry.computeVertexNormals() first'],
  ] as const) {
    if (mesh.geometry.hasAttribute(attribute)) continue
    throw new FurrowError({
      who: 'Wrinkles',
      problem: `mesh without ${attribute}`,
      value: mesh.name,
      limit: 'a mesh with positions, normals and UVs',
      remedy,
    })
  }
}

/** @throws FurrowError if a value is not a mesh of three.js. */
export function checkIsMesh(mesh: Mesh, who: string): void {
  if (!mesh?.isMesh || !mesh.geometry) throw wrongArgument(who, 'mesh', mesh, 'a Mesh of three.js')
}

/** @throws FurrowError if a value is not a mesh, or has no positions or normals. */
export function checkNormals(mesh: Mesh, who: string): void {
  checkIsMesh(mesh, who)
  const { attributes } = mesh.geometry
  if (attributes.position && attributes.normal) return
  throw wrongArgument(who, 'mesh', mesh.name, 'a mesh with positions and normals')
}

/**
 * Checks that a mesh is not instanced, for modes that cannot show different wrinkles per instance.
 *
 * @throws FurrowError if the mesh is instanced.
 */
export function checkNotInstanced(mesh: Mesh, mode: string): void {
  if (!instancesOf(mesh)) return
  throw new FurrowError({
    who: 'Wrinkles.mode',
    problem: 'mode unsupported for instances',
    value: mode,
    limit: 'default or off for an InstancedMesh or BatchedMesh',
    remedy: 'use the default mode',
  })
}
