import type { MaterialJson, SurfaceNames } from '../author/auto/character/judge-kind.ts'
import { joinParts, type PartInfluences, type SkinPart } from '../author/auto/surface/join-parts.ts'
import type { TangentFrame } from '../author/normals/height-to-normal.ts'
import type { SkinJoint } from '../author/skin/skeleton.ts'
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
  /** Joints that move the vertices: one set per four joints of a vertex. Empty if no joints do. */
  influences: readonly InfluenceSet[]
  /** For each joint of the skeleton, whether it belongs to the head. `whole` if all vertices follow the head; undefined if no vertex does. */
  head?: readonly boolean[] | 'whole' | undefined
}

/** Four joints (indices into the skeleton) and their weights per vertex. */
export interface InfluenceSet {
  joints: VectorData
  weights: VectorData
}

/** A mesh with one material. A mesh with several materials is passed as several `MeshData`. */
export interface MeshData {
  /** Names of the mesh and its material in the scene. */
  label: string
  parts: readonly PartData[]
  /** Names of the blendshapes, in the order of `PartData.targets`. */
  names: readonly string[]
  /** Names of VRM expressions that move a single blendshape, by index of the blendshape. */
  expressions?: ReadonlyMap<number, string> | undefined
  /** Column-major 4 x 4 matrix from mesh to world space. */
  placement: readonly number[]
  /** Joints of the skeleton in world space. Without joints, the skin has no skeleton. */
  joints?: readonly SkinJoint[] | undefined
  /** Whether wrinkles can be added to the mesh's material. */
  isLit: boolean
  /** Tangent frame in which the renderer reads normal maps. */
  frame: TangentFrame
}

/** A mesh of a character with its names in the file, which tell whether it is skin, cloth or hard. */
export interface CharacterMesh extends MeshData, SurfaceNames {
  /** Material in the file; undefined if the file has none. */
  materialJson: MaterialJson | undefined
}

/** All meshes of a character that blendshapes or joints move. */
export type CharacterData = readonly CharacterMesh[]

export function skinOf({ parts, names, expressions, placement, joints }: MeshData): Skin {
  return joinParts(parts.map(partOf), names, placement, expressions, joints)
}

function partOf({
  count,
  indices,
  positions,
  uvs,
  uvMatrix,
  targets,
  isRelative,
  ...part
}: PartData): SkinPart {
  return {
    count,
    indices: indices ?? Uint32Array.from({ length: count }, (_, i) => i),
    readPositions: (vertices, out) => read(positions, 3, vertices, out),
    readUvs(vertices, out) {
      read(uvs, 2, vertices, out)
      if (uvMatrix) transformUvs(out, uvMatrix)
    },
    readHeadWeights: part.head && ((vertices, out) => readHeadWeights(part, vertices, out)),
    influences: influencesOf(part.influences),
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

function readHeadWeights(
  { head, influences: [first] }: Pick<PartData, 'head' | 'influences'>,
  vertices: Uint32Array,
  out: Float32Array,
): void {
  if (head === 'whole') {
    out.fill(1)
    return
  }
  if (!head || !first) return
  const [own, shares] = readSet(first, vertices)
  for (let i = 0; i < own.length; i++) if (head[own[i]]) out[i >> 2] += shares[i]
}

function influencesOf(sets: readonly InfluenceSet[]): PartInfluences | undefined {
  if (sets.length === 0) return undefined
  const count = 4 * sets.length
  return {
    count,
    read(vertices, joints, weights) {
      for (const [k, set] of sets.entries()) {
        const [own, shares] = readSet(set, vertices)
        for (let i = 0; i < own.length; i++) {
          const at = count * (i >> 2) + 4 * k + (i & 3)
          joints[at] = own[i]
          weights[at] = shares[i]
        }
      }
      if (sets.length > 1) restoreFirstSet(weights, count)
    },
  }
}

/**
 * Scales the weights of the first set so that all weights of a vertex have the sum 1. When three.js loads a file, it scales the first set to the
 * sum 1 and ignores the other sets.
 */
function restoreFirstSet(weights: Float32Array, count: number): void {
  for (let start = 0; start < weights.length; start += count) {
    const sum = (from: number, to: number) =>
      weights.subarray(start + from, start + to).reduce((total, weight) => total + weight, 0)
    const first = sum(0, 4)
    const scale = first > 0 ? Math.max(0, 1 - sum(4, count)) / first : 0
    for (let k = 0; k < 4; k++) weights[start + k] *= scale
  }
}

function readSet({ joints, weights }: InfluenceSet, vertices: Uint32Array): [Float32Array, Float32Array] {
  const [own, shares] = [new Float32Array(4 * vertices.length), new Float32Array(4 * vertices.length)]
  read(joints, 4, vertices, own)
  read(weights, 4, vertices, shares)
  return [own, shares]
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
