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
 * Adds a flat normal map to a material that has none, if the UVs of the meshes are quantised and the base colour map has a texture transform.
 * Quantised UVs need the transform (KHR_mesh_quantization). The flat map gets a copy of the transform, because wrinkles use the texture
 * coordinates of the normal map.
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
 * Describes the meshes of a face as data for the worker that generates wrinkles. The matrix `placement` of the result converts positions of
 * all meshes to world space. The arrays of the geometries are not copied.
 *
 * @param expressions names of VRM expressions that move exactly one blendshape, by blendshape index.
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
 * Returns the matrix from mesh to world space in the rest pose. A skinned glTF mesh is placed by its joints, not by its node. In the rest
 * pose the matrix is the same for all joints, so the first joint is used.
 */
export function placementOf(mesh: Mesh): Matrix4 {
  mesh.updateWorldMatrix(true, false)
  const { skeleton } = mesh as SkinnedMesh
  const [bone] = skeleton?.bones ?? []
  if (!bone) return mesh.matrixWorld
  bone.updateWorldMatrix(true, false)
  return new Matrix4().multiplyMatrices(bone.matrixWorld, skeleton.boneInverses[0])
}
