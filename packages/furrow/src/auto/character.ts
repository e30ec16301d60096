import { joinParts, type SkinPart } from '../author/auto/surface/join-parts.ts'
import type { TangentFrame } from '../author/normals/height-to-normal.ts'
import type { Skin } from '../author/skin/surface.ts'

/** Vectors in the layout of a vertex buffer. A page can send its vertex buffers to the worker without converting them. */
export interface VectorData {
  array: ArrayLike<number> & ArrayBufferView
  /** Number of array elements from one vector to the next. */
  stride: number
  /** Index of the first element of the first vector. */
  start: number
  /** Whether integers in the array represent fractions. If so, the largest value of their type represents 1. */
  isNormalized: boolean
}

/** A part of a mesh. Each part has separate vertices. */
export interface PartData {
  /** Number of vertices. */
  count: number
  /** Three vertex indices per triangle. Without indices, every three vertices form a triangle. */
  indices?: ArrayLike<number> | undefined
  positions: VectorData
  uvs: VectorData
  /** Column-major 3 x 3 matrix that transforms texture coordinates of the normal map. Default: identity. */
  uvMatrix?: readonly number[] | undefined
  /** Vertex positions of each blendshape, or offsets if `isRelative`. */
  targets: readonly VectorData[]
  isRelative: boolean
  /** Joints and weights of the part's vertices. `whole` if all vertices follow the head joint; undefined if no vertex does. */
  head?: HeadData | 'whole' | undefined
}

/** Skinning of vertices. Each vertex has four joints and four weights. */
export interface HeadData {
  joints: VectorData
  weights: VectorData
  /** For each joint of the skeleton, whether it belongs to the head. */
  isHead: readonly boolean[]
}

/** A mesh with one material. A mesh with several materials is passed as several `MeshData`. */
export interface MeshData {
  /** Names of the mesh and its material, for error messages. */
  label: string
  parts: readonly PartData[]
  /** Names of the blendshapes, in the order of `PartData.targets`. */
  names: readonly string[]
  /** Names of VRM expressions that move a single blendshape, by index of the blendshape. */
  expressions?: ReadonlyMap<number, string> | undefined
  /** Column-major 4 x 4 matrix from mesh to world space. */
  placement: readonly number[]
  /** Whether wrinkles can be added to the mesh's material. */
  isLit: boolean
  /** Tangent frame in which the renderer reads normal maps. */
  frame: TangentFrame
}

/** All meshes of a character that have blendshapes. One of them is the skin. */
export type CharacterData = readonly MeshData[]

export function skinOf({ parts, names, expressions, placement }: MeshData): Skin {
  return joinParts(parts.map(partOf), names, placement, expressions)
}

function partOf({ count, indices, positions, uvs, uvMatrix, targets, isRelative, head }: PartData): SkinPart {
  return {
    count,
    indices: indices ?? Uint32Array.from({ length: count }, (_, i) => i),
    readPositions: (vertices, out) => read(positions, 3, vertices, out),
    readUvs(vertices, out) {
      read(uvs, 2, vertices, out)
      if (uvMatrix) transformUvs(out, uvMatrix)
    },
    readHeadWeights: head && ((vertices, out) => readHeadWeights(head, vertices, out)),
    readOffsets(k, vertices, out) {
      if (!targets[k]) return
      read(targets[k], 3, vertices, out)
      if (isRelative) return
      const rest = new Float32Array(out.length)
      read(positions, 3, vertices, rest)
      for (let i = 0; i < out.length; i++) out[i] -= rest[i]
    },
  }
}

function readHeadWeights(head: HeadData | 'whole', vertices: Uint32Array, out: Float32Array): void {
  if (head === 'whole') {
    out.fill(1)
    return
  }
  const { joints, weights, isHead } = head
  const [own, shares] = [joints, weights].map((data) => {
    const values = new Float32Array(4 * vertices.length)
    read(data, 4, vertices, values)
    return values
  })
  for (let i = 0; i < own.length; i++) if (isHead[own[i]]) out[i >> 2] += shares[i]
}

function read(data: VectorData, size: number, vertices: Uint32Array, out: Float32Array): void {
  const { array, stride, start, isNormalized } = data
  const largest = isNormalized ? maxOf(array) : 1
  for (let i = 0; i < vertices.length; i++) {
    const first = start + stride * vertices[i]
    // Normalised signed integers have two values for -1, e.g. -128 and -127 (glTF 2.0, 3.6.2.2).
    for (let k = 0; k < size; k++) {
      const value = array[first + k]
      out[size * i + k] = isNormalized ? Math.max(value / largest, -1) : value
    }
  }
}

function maxOf(array: ArrayBufferView): number {
  const bits = 8 * (array as Uint8Array).BYTES_PER_ELEMENT
  const isSigned = array instanceof Int8Array || array instanceof Int16Array || array instanceof Int32Array
  return 0xffffffff >>> (32 - (isSigned ? bits - 1 : bits))
}

function transformUvs(uvs: Float32Array, m: readonly number[]): void {
  for (let i = 0; i < uvs.length; i += 2) {
    const [u, v] = [uvs[i], uvs[i + 1]]
    uvs[i] = m[0] * u + m[3] * v + m[6]
    uvs[i + 1] = m[1] * u + m[4] * v + m[7]
  }
}
