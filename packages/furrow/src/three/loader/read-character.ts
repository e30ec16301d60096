import {
  type BufferAttribute,
  type BufferGeometry,
  type InterleavedBufferAttribute,
  Matrix4,
  type Mesh,
  type SkinnedMesh,
  type Texture,
} from 'three'
import type { MeshData, PartData, VectorData } from '../../auto/character.ts'
import { isOfHead } from '../camera/head-region.ts'
import { readsNormalMap, surfaceOf } from '../material/surface.ts'
import { flatNormalTexture } from '../material/textures.ts'
import { targetNames } from '../sources/morph.ts'

/** Whether a mesh has the positions, UVs and blendshapes that automatic wrinkles need. */
export function supportsAutoWrinkles({ geometry: { attributes, morphAttributes } }: Mesh): boolean {
  return Boolean(attributes.position && attributes.uv && morphAttributes.position?.length)
}

/**
 * Adds a flat normal map, with the base colour's transform, to a material without a normal map. Quantised UVs may need that transform
 * (KHR_mesh_quantization), and wrinkles use the normal map's coordinates.
 */
export function addFlatNormalMap(meshes: readonly [Mesh, ...Mesh[]]): void {
  const surface = surfaceOf(meshes[0])
  const { normalMap, map } = surface as { normalMap?: Texture | null; map?: Texture | null }
  if (!readsNormalMap(surface) || normalMap || !map) return
  const isMoved = map.rotation !== 0 || [map.offset, map.repeat].some(({ x, y }, i) => x !== i || y !== i)
  const areQuantised = meshes.every(({ geometry: { attributes } }) => {
    const uv = attributes[map.channel ? `uv${map.channel}` : 'uv']
    return uv && !(vectors(uv).array instanceof Float32Array)
  })
  if (isMoved && areQuantised) surface.normalMap = flatNormalTexture(map)
}

/**
 * Describes the meshes of a face as plain data, placed in world space by the first mesh or its skeleton. References the geometries'
 * arrays without copying.
 *
 * @param expressions names of VRM expressions that move exactly one target, by target index.
 */
export function readMeshes(
  meshes: readonly [Mesh, ...Mesh[]],
  expressions?: ReadonlyMap<number, string>,
): MeshData {
  const [mesh] = meshes
  const map = (surfaceOf(mesh) as { normalMap?: Texture | null }).normalMap
  return {
    label: `${mesh.name} ${surfaceOf(mesh).name}`,
    parts: meshes.map((part) => ({ ...partOf(part.geometry, map), head: headOf(part as SkinnedMesh) })),
    names: targetNames(mesh),
    expressions,
    placement: placementOf(mesh).toArray(),
    isLit: readsNormalMap(surfaceOf(mesh)),
    frame: meshes.every(({ geometry }) => geometry.hasAttribute('tangent')) ? 'orthonormal' : 'derivative',
  }
}

function partOf(
  { attributes, morphAttributes, morphTargetsRelative, index }: BufferGeometry,
  map: Texture | null | undefined,
): PartData {
  if (map?.matrixAutoUpdate) map.updateMatrix()
  return {
    count: attributes.position.count,
    indices: index?.array,
    positions: vectors(attributes.position),
    uvs: vectors((map?.channel && attributes[`uv${map.channel}`]) || attributes.uv),
    uvMatrix: map?.matrix.toArray(),
    targets: (morphAttributes.position ?? []).map(vectors),
    isRelative: morphTargetsRelative,
  }
}

function headOf({ skeleton, geometry, parent }: SkinnedMesh): PartData['head'] {
  if (!skeleton) return parent && isOfHead(parent) ? 'whole' : undefined
  const { skinIndex, skinWeight } = geometry.attributes
  const isHead = skeleton.bones.map(isOfHead)
  if (!isHead.includes(true) || !skinIndex || !skinWeight) return undefined
  return { joints: vectors(skinIndex), weights: vectors(skinWeight), isHead }
}

function vectors(attribute: BufferAttribute | InterleavedBufferAttribute): VectorData {
  const { array, itemSize, normalized: isNormalized } = attribute
  if (!('data' in attribute)) return { array, stride: itemSize, start: 0, isNormalized }
  return { array: attribute.data.array, stride: attribute.data.stride, start: attribute.offset, isNormalized }
}

/**
 * Matrix from mesh to world space in the rest pose. A skinned glTF mesh is placed by its joints, not by its node. In the rest pose all
 * joints give the same matrix.
 */
export function placementOf(mesh: Mesh): Matrix4 {
  mesh.updateWorldMatrix(true, false)
  const { skeleton } = mesh as SkinnedMesh
  const [bone] = skeleton?.bones ?? []
  if (!bone) return mesh.matrixWorld
  bone.updateWorldMatrix(true, false)
  return new Matrix4().multiplyMatrices(bone.matrixWorld, skeleton.boneInverses[0])
}
