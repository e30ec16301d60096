import type { WrinkleDriver } from 'furrow'
import { drivenFaces, MAX_NAME_LENGTH } from 'furrow/internal'
import { type GltfJson, type GltfMesh, targetNamesOf } from './gltf-json.ts'

/** Name of the mesh and the material that are chosen by default. */
export const DEFAULT_NAME = 'skin'

/** Indices of the mesh and the material that get wrinkles. */
export interface Target {
  mesh: number
  material: number
}

/** Names of a mesh and one of its materials. An index replaces a missing name. */
export interface TargetNames {
  mesh?: string | undefined
  material?: string | undefined
}

/**
 * Finds the mesh with the most blendshapes that drive the wrinkles of a material, see `drivenFaces`.
 *
 * @returns undefined if no mesh with texture coordinates has the material.
 */
export function targetOfMaterial(
  json: GltfJson,
  material: number,
  drivers: readonly WrinkleDriver[],
): Target | undefined {
  const usable = meshesOf(json).map(({ index }) => index)
  const mesh = facesOfMaterial(json, material, drivers).find((index) => usable.includes(index))
  return mesh === undefined ? undefined : { mesh, material }
}

/** Returns the indices of the meshes that show the wrinkles of a material, see `drivenFaces`. */
export function facesOfMaterial(
  json: GltfJson,
  material: number,
  drivers: readonly WrinkleDriver[],
): number[] {
  const meshes = [...(json.meshes ?? []).entries()].filter(([, { primitives }]) =>
    primitives.some((primitive) => primitive.material === material),
  )
  const measure = ([, mesh]: [number, GltfMesh]) => {
    const counts = mesh.primitives.map(({ attributes }) => {
      const position = json.accessors?.[attributes?.POSITION ?? -1] as { count?: number } | undefined
      return position?.count ?? 0
    })
    return { targets: targetNamesOf(mesh), vertices: Math.max(0, ...counts) }
  }
  return drivenFaces(meshes, measure, drivers).map(([index]) => index)
}

/**
 * Returns the names by which `findTarget` finds a mesh and a material. An index replaces a name that
 * is empty, too long or not unique.
 */
export function namesOfTarget(json: GltfJson, { mesh: index, material }: Target): TargetNames {
  const mesh = meshesOf(json).find((one) => one.index === index)
  if (!mesh) return {}
  return {
    mesh: uniqueName(meshesOf(json), mesh),
    material: uniqueName(
      materialsOf(json, mesh.index),
      materialsOf(json, mesh.index).find(({ target }) => target.material === material)!,
    ),
  }
}

/** A mesh or material with all names by which users can select it. */
export interface Candidate {
  index: number
  names: string[]
}

/** Lists the meshes that have texture coordinates. */
export function meshesOf(json: GltfJson): Candidate[] {
  return (json.meshes ?? []).flatMap(({ primitives }, index) => {
    return primitives.some(hasTextureCoordinates) ? [{ index, names: namesOfMesh(json, index) }] : []
  })
}

/** Lists the materials that a mesh uses on primitives with texture coordinates. */
export function materialsOf(json: GltfJson, mesh: number): (Candidate & { target: Target })[] {
  const primitives = json.meshes![mesh].primitives.filter(hasTextureCoordinates)
  return [...new Set(primitives.map(({ material }) => material))].flatMap((index) => {
    const material = index === undefined ? undefined : json.materials?.[index]
    if (index === undefined || !material) return []
    return [{ index, names: [material.name ?? String(index)], target: { mesh, material: index } }]
  })
}

function hasTextureCoordinates({ attributes }: GltfMesh['primitives'][number]): boolean {
  return attributes?.TEXCOORD_0 !== undefined
}

/**
 * Returns the names of a mesh and its nodes, and the index of the mesh. Omits the index if another mesh or node has it
 * as a name.
 */
export function namesOfMesh({ meshes = [], nodes = [] }: GltfJson, index: number): string[] {
  const placed = nodes.filter(({ mesh }) => mesh !== undefined)
  const own = [...meshes.slice(index, index + 1), ...placed.filter(({ mesh }) => mesh === index)]
  const names = own.flatMap(({ name }) => name ?? [])
  const isTaken = [...meshes, ...placed].some(({ name }) => name === String(index))
  return isTaken ? names : [...names, String(index)]
}

/** Selects candidates by name or index. Default: those named `DEFAULT_NAME`, or all if there are none. */
export function chosen<T extends Candidate>(
  candidates: readonly T[],
  wanted: string | undefined,
): readonly T[] {
  const named = candidates.filter(({ names }) => names.includes(wanted ?? DEFAULT_NAME))
  if (wanted === undefined) return named.length > 0 ? named : candidates
  return named.length > 0 ? named : candidates.filter(({ index }) => String(index) === wanted)
}

function uniqueName(candidates: readonly Candidate[], own: Candidate): string {
  const unique = own.names.find((name) => {
    return name !== '' && name.length <= MAX_NAME_LENGTH && chosen(candidates, name).length === 1
  })
  return unique ?? String(own.index)
}
