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
import { coveredTriangles, mostHalvings } from '../../relief/covered-triangles.ts'
import type { DenseMesh } from '../../relief/dense-mesh.ts'
import type { HeightField, Mask } from '../../relief/height-fields.ts'
import { heightLevels } from '../../relief/height-levels.ts'
import { neededHalvings } from '../../relief/needed-halvings.ts'
import { outwardRoom } from '../../relief/outward-room.ts'
import { SPLIT_DEFAULTS, splitMesh } from '../../relief/split-mesh.ts'
import { firstVertices, MAX_LEVEL } from '../../relief/welded-edges.ts'
import { wrinkleUvs } from '../mesh/wrinkle-uvs.ts'
import { coordinates, trianglesOf } from '../sources/geometry-arrays.ts'
import { COARSE_WIDTH } from './coarse-pass.ts'

/** How the layers move the surface; where heights are not in memory, only where they do; null for anywhere. */
export type Raised = readonly HeightField[] | Mask | null

/** What is split, and how. */
export interface SplitRequest {
  mesh: Mesh
  /** Only its triangles are drawn with relief, where the mesh has several materials. */
  material: Material
  raised: Raised
  /** Texel of the mesh's first vertex in the coarse textures. */
  first: number
  /** Metres per unit of the mesh's positions. */
  metresPerUnit: number
  /** Metres that heights can move the surface. */
  reach: number
  /** Size of the heights in texels. */
  map: { width: number; height: number }
}

/** The dense geometry of a mesh. */
export interface Split {
  /** Has a group for each version of the surface, the finest first. */
  geometry: BufferGeometry
  /** See `DenseMesh`. */
  edge: number
  /** The next vertex at the same position of each vertex; the last one's is the first. */
  next: Uint32Array
}

/**
 * Splits a mesh into the geometry that its relief is drawn with. Attributes of its own are interpolated; positions and normals that move
 * are read from the coarse textures by `furrowParents`, `furrowCorners` and `furrowWeights`.
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
  const room = yield* outwardRoom(coarse, normals, firstOf, reach)
  yield
  const attributes = { furrowRoom: mixParents(dense, room), furrowLevel: mixParents(dense, levels) }
  yield
  const dressed = yield* denseGeometry(geometry, dense, first, attributes)
  yield
  return { geometry: dressed, edge: dense.edge, next: ringOf(firstOf) }
}

function* halvingsFor(
  coarse: CoarseMesh,
  normals: Float32Array,
  raised: Raised,
  levels: Float32Array,
): Generator<void, Float32Array[]> {
  if (Array.isArray(raised)) return yield* neededHalvings(coarse, normals, raised, levels)
  if (raised) return [mostHalvings(coveredTriangles(coarse, raised as Mask))]
  return [new Float32Array(coarse.triangles.length).fill(MAX_LEVEL)]
}

/** A texture of the rings of all meshes, each of whose vertices begin at its first texel. */
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

/** The triangles of a mesh that a material is on. */
function drawnTriangles(mesh: Mesh, material: Material): ArrayLike<number> {
  const all = trianglesOf(mesh.geometry)
  const { material: own, geometry } = mesh
  if (!Array.isArray(own)) return all
  const groups = geometry.groups.filter(({ materialIndex = 0 }) => own[materialIndex] === material)
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

/** A number of each vertex, between those of its parents: the same on both sides of a seam. */
function mixParents({ count, parents, weights }: DenseMesh, values: Float32Array): Float32Array {
  const out = new Float32Array(count)
  for (let i = 0; i < count; i++) {
    for (let k = 3 * i; k < 3 * i + 3; k++) out[i] += weights[k] * values[parents[k]]
  }
  return out
}

/** Attributes that only deform the coarse mesh. */
const DEFORMING = ['skinIndex', 'skinWeight']

/** @param perVertex attributes of one number. */
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

/** One after the other in one index: a group each. */
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

/** Adds attributes of floats in one buffer: WebGPU guarantees no more than eight for a geometry. */
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
