import type { Material } from '@babylonjs/core/Materials/material.js'
import type { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js'
import type { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import { wrongArgument } from '../core/argument.ts'
import { FurrowError } from '../core/error.ts'
import type { ShaderKind } from './shaders/injections.ts'

/** A material whose shader can be edited. */
export type SkinMaterial = PBRMaterial | StandardMaterial

/** By the names of classes: to import the classes would add both materials to every page. */
const KINDS: Readonly<Record<string, ShaderKind>> = { PBRMaterial: 'pbr', StandardMaterial: 'standard' }

/** @throws FurrowError when a value is not a mesh of Babylon.js. */
export function checkIsMesh(mesh: AbstractMesh, who: string): void {
  if (typeof mesh?.isVerticesDataPresent === 'function') return
  throw wrongArgument(who, 'invalid mesh', mesh, 'a Mesh or InstancedMesh of Babylon.js')
}

/** @throws FurrowError when it has no positions, normals or UVs. */
export function checkMesh(mesh: AbstractMesh): void {
  checkIsMesh(mesh, 'Wrinkles')
  for (const [data, remedy] of [
    ['position', 'give the mesh its vertices first'],
    ['uv', 'unwrap the mesh: areas and layers are in its UV layout'],
    ['normal', 'call mesh.createNormals(true) first'],
  ] as const) {
    if (mesh.isVerticesDataPresent(data)) continue
    throw new FurrowError({
      who: 'Wrinkles',
      problem: `mesh without ${data}`,
      value: mesh.name,
      limit: 'a mesh with positions, normals and UVs',
      remedy,
    })
  }
}

/**
 * The material of a mesh, and what kind of shader it has.
 *
 * @throws FurrowError when its shader cannot be edited.
 */
export function checkMaterial({ material, name }: AbstractMesh): {
  material: SkinMaterial
  kind: ShaderKind
} {
  const className = material?.getClassName()
  const kind = KINDS[className ?? '']
  if (!kind) {
    throw new FurrowError({
      code: 'unsupported',
      who: 'Wrinkles',
      problem: `mesh "${name}" has a material that cannot show wrinkles`,
      value: className ?? 'none',
      limit: Object.keys(KINDS).join(', '),
      remedy: 'give the mesh one of these',
    })
  }
  const skin = material as SkinMaterial
  if (skin.useObjectSpaceNormalMap) {
    throw new FurrowError({
      code: 'unsupported',
      who: 'Wrinkles',
      problem: `material "${(material as Material).name}" has normals in object space`,
      limit: 'a normal map in tangent space',
      remedy: 'bake it again in tangent space',
    })
  }
  return { material: skin, kind }
}
