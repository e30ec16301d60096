import { latin1 } from '../base/bytes.ts'
import type { CheckedJson } from '../json/checked-json.ts'

// Byte offsets of the version, the encoder method, the flags and the connectivity data (Draco Bitstream Specification
// 2.2).
const MAGIC = 'DRACO'
const VERSION = 5
const METHOD = 8
const FLAGS = 9
const CONNECTIVITY = 11
const HAS_METADATA = 0x8000
const EDGEBREAKER = 1

/**
 * Checks that no Draco mesh decodes to more vertices or indices than its accessors declare. Otherwise 500 bytes could
 * decode to millions of points. Call `decodingProblem` first, because this check relies on valid indices and ranges.
 *
 * @param bin binary chunk.
 * @returns error text, or undefined.
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
      if (3 * faces > corners) return excess(i, 3 * faces, 'indices', corners)
      if (points > vertices) return excess(i, points, 'vertices', vertices)
    }
  }
  return undefined
}

function excess(mesh: number, count: number, items: string, declared: number): string {
  return `meshes[${mesh}] has ${count} ${items} in its Draco data, but its accessors declare ${declared}`
}

/** Reads the counts of a Draco mesh. Returns undefined if the data is not a mesh of version 2.2, or has metadata. */
function readCounts(bytes: Uint8Array): { points: number; faces: number } | undefined {
  const isMesh =
    bytes.length > CONNECTIVITY &&
    latin1(bytes.subarray(0, VERSION)) === MAGIC &&
    bytes.subarray(VERSION, METHOD).join() === '2,2,1' &&
    ((bytes[FLAGS] | (bytes[FLAGS + 1] << 8)) & HAS_METADATA) === 0
  if (!isMesh) return undefined
  let at = CONNECTIVITY
  /** Reads a LEB128 number: seven bits per byte, lowest first. */
  const next = () => {
    for (let value = 0, scale = 1; ; scale *= 128) {
      const byte = bytes[at++] ?? 0
      value += (byte & 0x7f) * scale
      if (byte < 0x80) return value
    }
  }
  if (bytes[METHOD] !== EDGEBREAKER) return { faces: next(), points: next() }
  // Skips the traversal method and the vertex count. The count is not checked here, because the decoder rejects data
  // with more vertices than triangle corners.
  at++
  next()
  return { faces: next(), points: 0 }
}
