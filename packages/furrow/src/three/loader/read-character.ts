import {
  type BufferAttribute,
  type BufferGeometry,
  type InterleavedBufferAttribute,
  Matrix4,
  type Mesh,
  type SkinnedMesh,
  type Texture,
} from 'three'
import type { InfluenceSet, MeshData, PartData, VectorData } from '../../auto/character.ts'
import { isOfHead } from '../camera/head-region.ts'
import { readsNormalMap, surfaceOf } from '../material/surface.ts'
import { flatNormalTexture } from '../material/textures.ts'
import { targetNames } from '../sources/morph.ts'

/** Whether a mesh has the positions, UVs and blendshapes that automatic wrinkles of faces need. */
export function supportsAutoWrinkles({ geometry }: Mesh): boolean {
  return hasSurface(geometry) && Boolean(geometry.morphAttributes.position?.length)
}

/** Whether a mesh has the positions, UVs and joints that automatic wrinkles at joints need, and a material that can show them. */
export function supportsJointWrinkles(mesh: Mesh): boolean {
  const { geometry, skeleton } = mesh as SkinnedMesh
  return hasSurface(geometry) && Boolean(skeleton) && readsNormalMap(surfaceOf(mesh))
}

function hasSurface({ attributes }: BufferGeometry): boolean {
  return Boolean(attributes.position && attributes.uv)
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
 * all meshes to world space. The arrays of the geometries are not copied. The result has no joints, see `bindMatrices`.
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
    influences: influencesOf(attributes),
  }
}

function headOf({ skeleton, parent }: SkinnedMesh): PartData['head'] {
  if (!skeleton) return parent && isOfHead(parent) ? 'whole' : undefined
  const isHead = skeleton.bones.map(isOfHead)
  return isHead.includes(true) ? isHead : undefined
}

/** Names of the first joints and weights of each vertex, and of the second ones, which `GLTFLoader` reads but does not use. */
const INFLUENCES = [
  ['skinIndex', 'skinWeight'],
  ['joints_1', 'weights_1'],
] as const

function influencesOf(attributes: BufferGeometry['attributes']): InfluenceSet[] {
  const sets: InfluenceSet[] = []
  for (const [joints, weights] of INFLUENCES) {
    if (!attributes[joints] || !attributes[weights]) break
    sets.push({ joints: vectors(attributes[joints]), weights: vectors(attributes[weights]) })
  }
  return sets
}

/** Returns the matrix from each joint of a skeleton to world space, in the rest pose. */
export function bindMatrices(mesh: SkinnedMesh): number[][] {
  const placement = placementOf(mesh)
  return mesh.skeleton.boneInverses.map((inverse) =>
    new Matrix4().copy(inverse).invert().premultiply(placement).toArray(),
  )
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
