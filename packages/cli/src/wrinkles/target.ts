import { FurrowError } from 'furrow'
import type { GltfJson, GltfMesh } from './glb-file.ts'

/** The mesh that is taken when the user names none and the file has one of this name. */
const USUAL_NAME = 'skin'

/** Where wrinkles go, by index. */
export interface Target {
  mesh: number
  material: number
}

/**
 * Finds the mesh that wrinkles, and its material.
 *
 * @param meshName name of the mesh or of its node; otherwise the one named `skin`, or the only one with texture
 *   coordinates.
 * @param materialName one of the mesh's materials; otherwise the one named `skin`, or the only one.
 * @throws FurrowError when there is none, or several and none is named.
 */
export function findTarget(json: GltfJson, who: string, meshName?: string, materialName?: string): Target {
  const meshes = (json.meshes ?? []).flatMap((mesh, index) => {
    return mesh.primitives.some(hasTexture) ? [{ index, names: namesOf(json, mesh, index) }] : []
  })
  const mesh = choose(meshes, meshName, who, 'mesh', '--mesh')
  const used = new Set(json.meshes![mesh].primitives.filter(hasTexture).map(({ material }) => material))
  const materials = [...used].flatMap((index) => {
    const material = index === undefined ? undefined : json.materials?.[index]
    return material ? [{ index: index!, names: [material.name ?? String(index)] }] : []
  })
  return { mesh, material: choose(materials, materialName, who, 'material of that mesh', '--material') }
}

/** Names of the blendshapes of a mesh, as three.js and others know them. */
export function targetNamesOf(mesh: GltfMesh): string[] {
  const count = mesh.primitives[0]?.targets?.length ?? 0
  const names = mesh.extras?.targetNames
  if (Array.isArray(names) && names.length === count) return names.map(String)
  return Array.from({ length: count }, (_, i) => String(i))
}

/** Names of all nodes, any of which a driver may name as a joint. */
export function jointNamesOf({ nodes = [] }: GltfJson): string[] {
  return nodes.flatMap(({ name }) => (name === undefined ? [] : [name]))
}

function hasTexture({ attributes }: GltfMesh['primitives'][number]): boolean {
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
  const usual = candidates.length === 1 ? candidates[0] : named(USUAL_NAME)
  const found = wanted === undefined ? usual : named(wanted)
  if (found) return found.index
  const all = candidates.map(({ names, index }) => names[0] ?? String(index))
  throw new FurrowError({
    who,
    what: wanted !== undefined || all.length === 0 ? `no such ${what}` : `several choices of a ${what}`,
    value: wanted,
    limit: all.length === 0 ? 'the file has none with texture coordinates' : all.join(', '),
    remedy: `name one with ${option}`,
  })
}
