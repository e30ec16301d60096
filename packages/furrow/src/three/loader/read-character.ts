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

/** Whether a mesh, at rest, has all that automatic wrinkles are made from. */
export function canCrease({ geometry: { attributes, morphAttributes } }: Mesh): boolean {
  return Boolean(attributes.position && attributes.uv && morphAttributes.position?.length)
}

/**
 * Gives a material without a normal map a flat one with the transform of its base colour. Quantised texture coordinates may be readable by that
 * transform alone (KHR_mesh_quantization), and wrinkles use the coordinates of the normal map.
 */
export function readQuantised(meshes: readonly [Mesh, ...Mesh[]]): void {
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
 * The meshes of a face as plain data, in world space as their first one or its skeleton places them now. Nothing is copied or converted: the
 * arrays are those of the geometries.
 *
 * @param expressions names of a VRM's expressions that move one target alone, by its index.
 */
export function readMeshes(
  meshes: readonly [Mesh, ...Mesh[]],
  expressions?: ReadonlyMap<number, string>,
): MeshData {
  const [mesh] = meshes
  const map = (surfaceOf(mesh) as { normalMap?: Texture | null }).normalMap
  return {
    label: `${mesh.name} ${surfaceOf(mesh).name}`,
    parts: meshes.map((own) => ({ ...partOf(own.geometry, map), head: headOf(own as SkinnedMesh) })),
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
 * The matrix from mesh to world space in the rest pose. glTF places a skinned mesh by its joints and ignores its node; in the rest pose
 * all joints give the same matrix.
 */
export function placementOf(mesh: Mesh): Matrix4 {
  mesh.updateWorldMatrix(true, false)
  const { skeleton } = mesh as SkinnedMesh
  const [bone] = skeleton?.bones ?? []
  if (!bone) return mesh.matrixWorld
  bone.updateWorldMatrix(true, false)
  return new Matrix4().multiplyMatrices(bone.matrixWorld, skeleton.boneInverses[0])
}
