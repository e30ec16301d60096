import { hoistTargetNames } from 'furrow/internal'
import { concat, fromUtf8, utf8 } from '../base/bytes.ts'
import { firstLine } from '../base/errors.ts'
import { checkFileBytes, MAX_JSON_BYTES } from '../base/file-size.ts'
import type { ReadReference } from '../base/references.ts'
import { costProblem } from '../checks/document.ts'
import { shapeProblem } from '../checks/shape.ts'
import type { GltfJson } from '../json/gltf-json.ts'
import { embedFiles } from './embed-files.ts'
import type { Glb } from './glb.ts'
import { CHOOSE_FACE, otherFormat, unusable } from './not-gltf.ts'

// GLB file format (glTF 2.0, 4.4): a 12-byte header, then chunks with 8-byte headers.
const MAGIC = 0x46546c67
const JSON_CHUNK = 0x4e4f534a
const BIN_CHUNK = 0x004e4942
/** Byte offset of the JSON in a `.glb`. */
const JSON_START = 20

/**
 * Parses a `.glb`, `.vrm` or `.gltf`, which is recognised by its content. Copies referenced buffers and images into the
 * binary chunk.
 *
 * @param path path of the file, for errors.
 * @throws FurrowError if the file is truncated, is not glTF 2.0, has unreadable references, or would take too much time
 *   or memory (see `costProblem`).
 */
export async function openGlb(
  bytes: Uint8Array,
  path: string,
  who: string,
  read: ReadReference,
): Promise<Glb> {
  const glb = decodeGlb(bytes, path, who)
  await embedFiles(glb, path, who, read)
  const problem = costProblem(glb.json, glb.fileBytes)
  if (problem) throw unusable(path, who, problem)
  return glb
}

/** Splits a file into JSON and binary chunk. Throws if the file is truncated, or is not glTF 2.0. */
export function decodeGlb(bytes: Uint8Array, path: string, who: string): Glb {
  checkHead(bytes, bytes.length, path, who)
  const [start, end] = isJson(bytes) ? [0, bytes.length] : [JSON_START, JSON_START + uint32(bytes, 12)]
  let json: GltfJson
  try {
    json = JSON.parse(fromUtf8(bytes.subarray(start, end)).replace(/^\ufeff/, ''))
  } catch (error) {
    throw unusable(path, who, `its JSON is malformed (${firstLine(error)})`)
  }
  hoistTargetNames(json)
  const problem = shapeProblem(json)
  if (problem) {
    const isOther = (json as { asset?: unknown } | null)?.asset === undefined
    throw unusable(path, who, problem, { remedy: isOther ? CHOOSE_FACE : undefined })
  }
  const bin = binaryChunk(bytes, end)
  if (!bin) throw unusable(path, who, 'its binary chunk is truncated')
  return { json, bin, fileBytes: bytes.length, bytes, references: new Map() }
}

export function encodeGlb({ json, bin }: Glb): Uint8Array {
  const text = padded(utf8(JSON.stringify(json)), 0x20)
  const data = padded(bin, 0)
  const length = JSON_START + text.length + (data.length > 0 ? 8 + data.length : 0)
  const header = words(MAGIC, 2, length, text.length, JSON_CHUNK)
  if (data.length === 0) return concat([header, text])
  return concat([header, text, words(data.length, BIN_CHUNK), data])
}

/** Returns whether a file starts like JSON, so that it may be a `.gltf`. */
function isJson(head: Uint8Array): boolean {
  return /^[\s\ufeff]*\{/.test(fromUtf8(head.subarray(0, 64)))
}

/**
 * Checks the first bytes of a file and the size of its JSON.
 *
 * @param head first bytes of the file: at least the 20 bytes before the JSON of a `.glb`, unless the file is shorter.
 * @throws FurrowError if the file is neither JSON nor binary glTF 2.0, is truncated before the end of its JSON, or has
 *   more JSON than `MAX_JSON_BYTES`.
 */
export function checkHead(head: Uint8Array, size: number, path: string, who: string): void {
  const problem = isJson(head) ? undefined : headerProblem(head, size)
  if (problem) {
    const other = otherFormat(head)
    throw unusable(path, who, other?.problem ?? problem, { remedy: other?.remedy })
  }
  checkFileBytes(isJson(head) ? size : uint32(head, 12), `the JSON of ${path}`, who, MAX_JSON_BYTES)
}

function headerProblem(head: Uint8Array, size: number): string | undefined {
  if (head.length < 4 || uint32(head, 0) !== MAGIC) return 'it does not begin with "glTF"'
  if (head.length < JSON_START) return `it is truncated after ${size} bytes`
  if (uint32(head, 4) !== 2) return `it has version ${uint32(head, 4)}`
  const length = uint32(head, 8)
  if (length > size || JSON_START + uint32(head, 12) > size) {
    return `it is truncated: ${size} of ${length} bytes`
  }
  if (uint32(head, 16) !== JSON_CHUNK) return 'its first chunk is not JSON'
  return undefined
}

/**
 * Returns the data of the binary chunk at `start`. Returns an empty array if there is no binary chunk, and undefined if
 * the chunk is truncated.
 */
function binaryChunk(bytes: Uint8Array, start: number): Uint8Array | undefined {
  if (bytes.length < start + 8) return new Uint8Array()
  if (uint32(bytes, start + 4) !== BIN_CHUNK) return new Uint8Array()
  const end = start + 8 + uint32(bytes, start)
  return end > bytes.length ? undefined : bytes.subarray(start + 8, end)
}

function padded(bytes: Uint8Array, fill: number): Uint8Array {
  const gap = (4 - (bytes.length % 4)) % 4
  return gap === 0 ? bytes : concat([bytes, new Uint8Array(gap).fill(fill)])
}

function uint32(bytes: Uint8Array, offset: number): number {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength).getUint32(offset, true)
}

function words(...values: number[]): Uint8Array {
  const view = new DataView(new ArrayBuffer(4 * values.length))
  for (const [i, value] of values.entries()) view.setUint32(4 * i, value, true)
  return new Uint8Array(view.buffer)
}
