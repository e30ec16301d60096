import { FurrowError, LONGEST_NAME } from 'furrow'
import { mostMovedSkin } from '../auto/find-skin.ts'
import { didYouMean } from '../nearest.ts'
import { documentOf } from './document.ts'
import type { Glb } from './glb-file.ts'
import type { GltfJson, GltfMesh } from './gltf-json.ts'
import { DEFAULT_NAME } from './mesh-nodes.ts'

/** Indices of the mesh and the material that get wrinkles. */
export interface Target {
  mesh: number
  material: number
}

/** Names of a mesh and of one of its materials, or their indices where they have no name. */
export interface TargetNames {
  mesh?: string | undefined
  material?: string | undefined
}

/**
 * Finds the mesh that gets wrinkles, and its material: those that are named, or else those named `skin`, the only ones, or as
 * `furrow auto` finds them, by what the blendshapes move.
 *
 * @param path of the file, for errors.
 * @param names the mesh may also be named by its node.
 * @throws FurrowError when there is none, or several and none stands out.
 */
export async function findTarget(glb: Glb, path: string, who: string, names: TargetNames): Promise<Target> {
  const { json } = glb
  const meshes = chosen(meshesOf(json), names.mesh)
  if (meshes.length === 0) throw notFound(meshesOf(json), names.mesh, who, 'mesh', '--mesh')
  const materials = meshes.flatMap(({ index }) => materialsOf(json, index))
  // One of several meshes is not chosen because its material has the default name.
  const left =
    meshes.length > 1 && names.material === undefined ? materials : chosen(materials, names.material)
  if (left.length === 0) {
    throw notFound(materials, names.material, who, 'material of that mesh', '--material')
  }
  if (left.length === 1) return left[0].target
  const meshName = meshes.length === 1 ? json.meshes?.[meshes[0].index].name : undefined
  const skin = mostMovedSkin(await documentOf(glb, path, who), meshName)
  const moved = left.find(({ target }) => target.mesh === skin?.mesh && target.material === skin.material)
  if (moved) return moved.target
  throw meshes.length > 1
    ? notFound(meshes, undefined, who, 'mesh', '--mesh')
    : notFound(left, undefined, who, 'material of that mesh', '--material')
}

/** Names by which `findTarget` finds a material with wrinkles and the first mesh that has it; an index where no name does. */
export function namesOfTarget(json: GltfJson, material: number): TargetNames {
  const mesh = meshesOf(json).find(({ index }) => {
    return materialsOf(json, index).some(({ target }) => target.material === material)
  })
  if (!mesh) return {}
  return {
    mesh: uniqueName(meshesOf(json), mesh),
    material: uniqueName(
      materialsOf(json, mesh.index),
      materialsOf(json, mesh.index).find(({ target }) => target.material === material)!,
    ),
  }
}

interface Candidate {
  index: number
  names: string[]
}

/** The meshes with texture coordinates. */
function meshesOf(json: GltfJson): Candidate[] {
  return (json.meshes ?? []).flatMap((mesh, index) => {
    return mesh.primitives.some(hasTextureCoordinates) ? [{ index, names: namesOf(json, mesh, index) }] : []
  })
}

/** The materials of a mesh where it has texture coordinates. */
function materialsOf(json: GltfJson, mesh: number): (Candidate & { target: Target })[] {
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

function namesOf({ nodes = [] }: GltfJson, mesh: GltfMesh, index: number): string[] {
  const nodeNames = nodes.filter((node) => node.mesh === index).map(({ name }) => name)
  const names = [mesh.name, ...nodeNames].filter((name) => name !== undefined)
  return names.length > 0 ? names : [String(index)]
}

/** Those of a name; without one, those of the default name, or all where none has that. */
function chosen<T extends Candidate>(candidates: readonly T[], wanted: string | undefined): readonly T[] {
  const named = candidates.filter(({ names }) => names.includes(wanted ?? DEFAULT_NAME))
  if (wanted === undefined) return named.length > 0 ? named : candidates
  return named.length > 0 ? named : candidates.filter(({ index }) => String(index) === wanted)
}

function uniqueName(candidates: readonly Candidate[], own: Candidate): string {
  const unique = own.names.find((name) => {
    return name !== '' && name.length <= LONGEST_NAME && chosen(candidates, name).length === 1
  })
  return unique ?? String(own.index)
}

function notFound(
  candidates: readonly Candidate[],
  wanted: string | undefined,
  who: string,
  what: string,
  option: string,
): FurrowError {
  const all = candidates.map(({ names, index }) => names[0] ?? String(index))
  return new FurrowError({
    code: 'unknown-name',
    who,
    what: wanted !== undefined || all.length === 0 ? `no such ${what}` : `several candidates for the ${what}`,
    value: wanted,
    limit: all.length === 0 ? 'the file has none with texture coordinates' : all.join(', '),
    remedy: didYouMean(wanted, all, `name one with ${option}`),
  })
}
