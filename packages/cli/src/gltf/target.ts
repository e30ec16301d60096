import { FurrowError } from 'furrow'
import type { GltfJson, GltfMesh } from './gltf-json.ts'
import { DEFAULT_NAME } from './mesh-nodes.ts'

/** Indices of the mesh and the material that get wrinkles. */
export interface Target {
  mesh: number
  material: number
}

/**
 * Finds the mesh that gets wrinkles, and its material.
 *
 * @param meshName name of the mesh or of its node; by default `skin`, or the only mesh with texture coordinates.
 * @param materialName one of the mesh's materials; by default `skin`, or the only one.
 * @throws FurrowError when there is none, or several and none is named.
 */
export function findTarget(json: GltfJson, who: string, meshName?: string, materialName?: string): Target {
  const meshes = (json.meshes ?? []).flatMap((mesh, index) => {
    return mesh.primitives.some(hasTextureCoordinates) ? [{ index, names: namesOf(json, mesh, index) }] : []
  })
  const mesh = choose(meshes, meshName, who, 'mesh', '--mesh')
  const used = new Set(
    json.meshes![mesh].primitives.filter(hasTextureCoordinates).map(({ material }) => material),
  )
  const materials = [...used].flatMap((index) => {
    const material = index === undefined ? undefined : json.materials?.[index]
    return material ? [{ index: index!, names: [material.name ?? String(index)] }] : []
  })
  return { mesh, material: choose(materials, materialName, who, 'material of that mesh', '--material') }
}

function hasTextureCoordinates({ attributes }: GltfMesh['primitives'][number]): boolean {
  return attributes?.TEXCOORD_0 !== undefined
}

function namesOf({ nodes = [] }: GltfJson, mesh: GltfMesh, index: number): string[] {
  const nodeNames = nodes.filter((node) => node.mesh === index).map(({ name }) => name)
  return [mesh.name, ...nodeNames].filter((name) => name !== undefined)
}

function choose(
  candidates: { index: number; names: string[] }[],
  wanted: string | undefined,
  who: string,
  what: string,
  option: string,
): number {
  const named = (name: string) => candidates.find(({ names }) => names.includes(name))
  const fallback = candidates.length === 1 ? candidates[0] : named(DEFAULT_NAME)
  const found = wanted === undefined ? fallback : named(wanted)
  if (found) return found.index
  const all = candidates.map(({ names, index }) => names[0] ?? String(index))
  throw new FurrowError({
    code: 'unknown-name',
    who,
    what: wanted !== undefined || all.length === 0 ? `no such ${what}` : `several candidates for the ${what}`,
    value: wanted,
    limit: all.length === 0 ? 'the file has none with texture coordinates' : all.join(', '),
    remedy: `name one with ${option}`,
  })
}
