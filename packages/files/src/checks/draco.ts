import { latin1 } from '../base/bytes.ts'
import type { CheckedJson } from '../json/checked-json.ts'

// Byte offsets in a Draco stream (Draco Bitstream Specification 2.2): header, connectivity method, counts.
const MAGIC = 'DRACO'
const VERSION = 5
const METHOD = 8
const FLAGS = 9
const CONNECTIVITY = 11
const HAS_METADATA = 0x8000
const EDGEBREAKER = 1

/**
 * Checks that Draco meshes do not exceed the counts of their accessors: 500 bytes can encode millions of points. Expects
 * valid references and ranges.
 *
 * @param bin the binary chunk.
 * @returns the problem, or undefined.
 */
export function dracoProblem(
  { accessors = [], bufferViews = [], meshes = [] }: CheckedJson,
  bin: Uint8Array,
): string | undefined {
  for (const [i, { primitives }] of meshes.entries()) {
    for (const { attributes = {}, indices, extensions } of primitives) {
      const draco = extensions?.KHR_draco_mesh_compression
      if (!draco) continue
      const { byteOffset = 0, byteLength } = bufferViews[draco.bufferView]
      const counts = readCounts(bin.subarray(byteOffset, byteOffset + byteLength))
      if (!counts) return `meshes[${i}] has Draco data that glTF does not allow`
      const vertices = accessors[attributes.POSITION ?? -1]?.count ?? 0
      const corners = accessors[indices ?? -1]?.count ?? vertices
      const { points, faces } = counts
      if (3 * faces > corners) return `meshes[${i}] holds ${3 * faces} indices, its accessor ${corners}`
      if (points > vertices) return `meshes[${i}] holds ${points} vertices, its accessors ${vertices}`
    }
  }
  return undefined
}

/** Returns undefined if the data is not a mesh of version 2.2, or has metadata, which glTF does not use. */
function readCounts(bytes: Uint8Array): { points: number; faces: number } | undefined {
  const isMesh =
    bytes.length > CONNECTIVITY &&
    latin1(bytes.subarray(0, VERSION)) === MAGIC &&
    bytes.subarray(VERSION, METHOD).join() === '2,2,1' &&
    ((bytes[FLAGS] | (bytes[FLAGS + 1] << 8)) & HAS_METADATA) === 0
  if (!isMesh) return undefined
  let at = CONNECTIVITY
  /** Reads LEB128: seven bits per byte, lowest first. */
  const next = () => {
    for (let value = 0, scale = 1; ; scale *= 128) {
      const byte = bytes[at++] ?? 0
      value += (byte & 0x7f) * scale
      if (byte < 0x80) return value
    }
  }
  if (bytes[METHOD] !== EDGEBREAKER) return { faces: next(), points: next() }
  // Skips the traversal method and the vertex count, which the decoder limits to the number of corners.
  at++
  next()
  return { faces: next(), points: 0 }
}
