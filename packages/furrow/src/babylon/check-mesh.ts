import type { Material } from '@babylonjs/core/Materials/material.js'
import type { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js'
import type { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import { wrongArgument } from '../core/argument.ts'
import { FurrowError } from '../core/error.ts'
import type { ShaderKind } from './shaders/injections.ts'

/** A material whose shader can be patched to draw wrinkles. */
export type SkinMaterial = PBRMaterial | StandardMaterial

/** Shader kinds by class name of the material. Importing the classes would add the code of both materials to every page. */
const KINDS: Readonly<Record<string, ShaderKind>> = { PBRMaterial: 'pbr', StandardMaterial: 'standard' }

/** @throws FurrowError if a value is not a mesh of Babylon.js. */
export function checkIsMesh(mesh: AbstractMesh, who: string): void {
  if (typeof mesh?.isVerticesDataPresent === 'function') return
  throw wrongArgument(who, 'mesh', mesh, 'a Mesh or InstancedMesh of Babylon.js')
}

/** @throws FurrowError if the mesh has no positions, normals or UVs. */
export function checkMesh(mesh: AbstractMesh): void {
  checkIsMesh(mesh, 'Wrinkles')
  for (const [data, remedy] of [
    ['position', 'add positions first'],
    ['uv', 'unwrap the mesh: areas and layers use its UV layout'],
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
 * Returns the material of a mesh, and the kind of its shader.
 *
 * @throws FurrowError if the shader cannot be patched.
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
      problem: `unsupported material of mesh "${name}"`,
      value: className ?? 'none',
      limit: Object.keys(KINDS).join(', '),
      remedy: 'use a supported material',
    })
  }
  const skin = material as SkinMaterial
  if (skin.useObjectSpaceNormalMap) {
    throw new FurrowError({
      code: 'unsupported',
      who: 'Wrinkles',
      problem: `material "${(material as Material).name}" has an object-space normal map`,
      limit: 'a tangent-space normal map',
      remedy: 'bake the normal map to tangent space',
    })
  }
  return { material: skin, kind }
}
