import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  FloatType,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  type Material,
  type Mesh,
  RedFormat,
} from 'three'
import type { CoarseMesh } from '../../relief/coarse-mesh.ts'
import { coveredTriangles, maxHalvings } from '../../relief/covered-triangles.ts'
import type { DenseMesh } from '../../relief/dense-mesh.ts'
import type { HeightField, Mask } from '../../relief/height-fields.ts'
import { heightLevels } from '../../relief/height-levels.ts'
import { neededHalvings } from '../../relief/needed-halvings.ts'
import { outwardClearance } from '../../relief/outward-clearance.ts'
import { SPLIT_DEFAULTS, splitMesh } from '../../relief/split-mesh.ts'
import { firstVertices, MAX_LEVEL } from '../../relief/welded-edges.ts'
import { wrinkleUvs } from '../mesh/wrinkle-uvs.ts'
import { coordinates, trianglesOf } from '../sources/geometry-arrays.ts'
import { COARSE_WIDTH } from './coarse-pass.ts'

/**
 * Region of the surface that height maps may displace. It is given as the heights of the layers, or as a mask of texels if the heights are
 * not in CPU memory. Null is the whole surface.
 */
export type Raised = readonly HeightField[] | Mask | null

export interface SplitRequest {
  mesh: Mesh
  /** If the mesh has several materials, only the triangles of this material are split. */
  material: Material
  raised: Raised
  /** Texel of the mesh's first vertex in the textures of `CoarsePass`. */
  first: number
  /** Metres per unit of the mesh's positions. */
  metresPerUnit: number
  /** Maximum displacement by height maps, metres. */
  reach: number
  /** Size of the height maps, texels. */
  map: { width: number; height: number }
}

/** Dense geometry of a mesh: its triangles, split into small triangles that height maps can displace. */
export interface Split {
  /** Geometry with one group per level of detail, finest first. */
  geometry: BufferGeometry
  /** Target edge length, metres. */
  edge: number
  /** For each vertex of the mesh, the next vertex at the same position. The last vertex at a position is followed by the first. */
  next: Uint32Array
}

/**
 * Splits the wrinkled triangles of a mesh into small triangles, and interpolates the mesh's attributes for the new vertices. Shaders find the
 * deformed vertices of the original triangle by the attributes `furrowParents`, `furrowCorners` and `furrowWeights`; see `DenseMesh`. The
 * attribute `furrowClearance` is the maximum displacement outwards, in metres; see `outwardClearance`. The attribute `furrowLevel` is the
 * mipmap level of the height map to sample.
 */
export function* splitGeometry(request: SplitRequest): Generator<void, Split> {
  const { mesh, material, raised, first, metresPerUnit, reach, map } = request
  const { geometry } = mesh
  const positions = coordinates(geometry.attributes.position)
  for (let i = 0; i < positions.length; i++) positions[i] *= metresPerUnit
  const coarse = { positions, uvs: wrinkleUvs(mesh, material), triangles: drawnTriangles(mesh, material) }
  const normals = coordinates(geometry.attributes.normal)
  yield
  const firstOf = firstVertices(positions)
  yield
  const levels = heightLevels(coarse, firstOf, SPLIT_DEFAULTS.edge, map)
  yield
  const [halvings, ...coarser] = yield* halvingsFor(coarse, normals, raised, levels)
  yield
  const dense = yield* splitMesh(coarse, halvings, { coarser })
  yield
  const clearance = yield* outwardClearance(coarse, normals, firstOf, reach)
  yield
  const attributes = { furrowClearance: mixParents(dense, clearance), furrowLevel: mixParents(dense, levels) }
  yield
  const split = yield* denseGeometry(geometry, dense, first, attributes)
  yield
  return { geometry: split, edge: dense.edge, next: ringOf(firstOf) }
}

function* halvingsFor(
  coarse: CoarseMesh,
  normals: Float32Array,
  raised: Raised,
  levels: Float32Array,
): Generator<void, Float32Array[]> {
  if (Array.isArray(raised)) return yield* neededHalvings(coarse, normals, raised, levels)
  if (raised) return [maxHalvings(coveredTriangles(coarse, raised as Mask))]
  return [new Float32Array(coarse.triangles.length).fill(MAX_LEVEL)]
}

/** Creates the texture `ring` of `CoarsePass`. It maps the texel of each vertex to the texel of the next vertex at the same position. */
export function ringTexture(splits: readonly { next: Uint32Array; first: number }[]): DataTexture {
  const count = splits.reduce((sum, { next }) => sum + next.length, 0)
  const rows = Math.ceil(count / COARSE_WIDTH)
  const data = new Float32Array(COARSE_WIDTH * rows)
  for (const { next, first } of splits)
    for (const [i, value] of next.entries()) data[first + i] = first + value
  const texture = new DataTexture(data, COARSE_WIDTH, rows, RedFormat, FloatType)
  texture.needsUpdate = true
  return texture
}

function drawnTriangles(mesh: Mesh, material: Material): ArrayLike<number> {
  const all = trianglesOf(mesh.geometry)
  const { material: materials, geometry } = mesh
  if (!Array.isArray(materials)) return all
  const groups = geometry.groups.filter(({ materialIndex = 0 }) => materials[materialIndex] === material)
  return groups.flatMap(({ start, count }) =>
    Array.from({ length: Math.min(count, all.length - start) }, (_, i) => all[start + i]),
  )
}

function ringOf(firstOf: Uint32Array): Uint32Array {
  const next = Uint32Array.from(firstOf.keys())
  for (let vertex = 0; vertex < firstOf.length; vertex++) {
    const first = firstOf[vertex]
    if (vertex === first) continue
    next[vertex] = next[first]
    next[first] = vertex
  }
  return next
}

/** Interpolates numbers from the vertices of the mesh to the dense vertices. Copies of a dense vertex at a seam get equal numbers. */
function mixParents({ count, parents, weights }: DenseMesh, values: Float32Array): Float32Array {
  const out = new Float32Array(count)
  for (let i = 0; i < count; i++) {
    for (let k = 3 * i; k < 3 * i + 3; k++) out[i] += weights[k] * values[parents[k]]
  }
  return out
}

/** Attributes that dense geometries do not need, because their shaders read deformed vertices from textures. */
const DEFORMING = ['skinIndex', 'skinWeight']

/** @param perVertex attributes with one float per vertex, by name. */
function* denseGeometry(
  { attributes }: BufferGeometry,
  dense: DenseMesh,
  first: number,
  perVertex: Record<string, Float32Array>,
): Generator<void, BufferGeometry> {
  const geometry = new BufferGeometry()
  for (const [name, attribute] of Object.entries(attributes)) {
    if (DEFORMING.includes(name)) continue
    const { itemSize } = attribute
    const values = interpolate(coordinates(attribute, itemSize), itemSize, dense)
    geometry.setAttribute(name, new BufferAttribute(values, itemSize))
    yield
  }
  const { parents, corners, weights, uvs } = dense
  addInterleaved(geometry, dense.count, [
    ['furrowParents', parents.map((i) => first + i), 3],
    ['furrowCorners', corners.map((i) => first + i), 3],
    ['furrowWeights', weights, 3],
    ['furrowUvs', uvs, 4],
    ...Object.entries(perVertex).map(([name, values]) => [name, values, 1] as const),
  ])
  yield
  addVersions(geometry, [dense.triangles, ...dense.coarser])
  return geometry
}

/** Sets an index that contains the triangles of all levels of detail, with one group per level. */
function addVersions(geometry: BufferGeometry, versions: readonly Uint32Array[]): void {
  const index = new Uint32Array(versions.reduce((sum, { length }) => sum + length, 0))
  let start = 0
  for (const triangles of versions) {
    index.set(triangles, start)
    geometry.addGroup(start, triangles.length)
    start += triangles.length
  }
  geometry.setIndex(new BufferAttribute(index, 1))
}

/** Adds float attributes in one interleaved buffer, because WebGPU guarantees only eight vertex buffers. */
function addInterleaved(
  geometry: BufferGeometry,
  count: number,
  parts: readonly (readonly [name: string, values: Float32Array | Uint32Array, size: number])[],
): void {
  const stride = parts.reduce((sum, [, , size]) => sum + size, 0)
  const all = new Float32Array(stride * count)
  const buffer = new InterleavedBuffer(all, stride)
  let offset = 0
  for (const [name, values, size] of parts) {
    for (let i = 0; i < count; i++) {
      for (let k = 0; k < size; k++) all[stride * i + offset + k] = values[size * i + k]
    }
    geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, size, offset))
    offset += size
  }
}

function interpolate(
  values: Float32Array,
  size: number,
  { count, corners, weights }: DenseMesh,
): Float32Array {
  const out = new Float32Array(size * count)
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < 3; k++) {
      const corner = corners[3 * i + k]
      const weight = weights[3 * i + k]
      if (weight === 0) continue
      for (let n = 0; n < size; n++) out[size * i + n] += weight * values[size * corner + n]
    }
  }
  return out
}
