import type { Mesh, SkinnedMesh } from 'three'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { CharacterMesh } from '../../auto/character.ts'
import { jointNodes, keyRotations, rotationChannels } from '../../auto/skeleton-json.ts'
import { surfaceOf } from '../material/surface.ts'
import { bindMatrices } from './read-character.ts'

/** Returns the names and the material of a mesh in its file. Unlike in the scene, the names are unchanged. */
export function surfaceInFile(
  { json, associations }: GLTFParser,
  mesh: Mesh,
): Pick<CharacterMesh, 'meshName' | 'materialName' | 'materialJson'> {
  const surface = surfaceOf(mesh)
  const [index, material] = [associations.get(mesh)?.meshes, associations.get(surface)?.materials]
  return {
    meshName: index === undefined ? mesh.name : json.meshes[index].name || String(index),
    materialName: material === undefined ? surface.name : json.materials[material].name || String(material),
    materialJson: material === undefined ? undefined : json.materials[material],
  }
}

/** Skeleton of a mesh in its rest pose. */
export interface BoundSkin {
  /** Index of the skin in the file. */
  skin: number
  /** See `bindMatrices`. */
  binds: number[][]
}

/** Reads the rest pose of a mesh's skeleton. Returns undefined if the file does not describe the skeleton. */
export function readBoundSkin({ json, associations }: GLTFParser, mesh: Mesh): BoundSkin | undefined {
  const { skeleton } = mesh as Partial<SkinnedMesh>
  // The primitives of a mesh are children of the object of its node.
  const node = associations.get(mesh)?.nodes ?? (mesh.parent && associations.get(mesh.parent)?.nodes)
  const skin = json.nodes?.[node ?? -1]?.skin
  // `GLTFLoader` leaves out joints that it cannot load.
  if (!skeleton || skin === undefined || jointNodes(json, skin).length !== skeleton.bones.length)
    return undefined
  return { skin, binds: bindMatrices(mesh as SkinnedMesh) }
}

/** Reads the rotations that the animations of a file give nodes, by index of the node. Skips channels that cannot be read. */
export async function animatedRotations(parser: GLTFParser): Promise<Map<number, number[][]>> {
  const found = new Map<number, number[][]>()
  for (const { node, output, interpolation } of rotationChannels(parser.json)) {
    const accessor = await parser.getDependency('accessor', output).catch(() => undefined)
    if (!accessor) continue
    const read = (i: number) => [accessor.getX(i), accessor.getY(i), accessor.getZ(i), accessor.getW(i)]
    const rotations = keyRotations(interpolation, accessor.count, read)
    found.set(node, [...(found.get(node) ?? []), ...rotations])
  }
  return found
}
