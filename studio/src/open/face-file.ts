import { FurrowError } from 'furrow'
import { costProblem } from '../../../packages/cli/src/gltf/checks/document.ts'
import { shapeProblem } from '../../../packages/cli/src/gltf/checks/shape.ts'
import type { GltfJson } from '../../../packages/cli/src/gltf/gltf-json.ts'
import { otherFormat, unusable } from '../../../packages/cli/src/gltf/not-gltf.ts'
import { bytesOf, type DroppedFile } from './dropped-files.ts'

/** A glTF file that was read but not decoded, and the files that it refers to. */
export interface FaceFile {
  bytes: Uint8Array<ArrayBuffer>
  json: GltfJson
  /** By the URIs in the file. */
  references: ReadonlyMap<string, DroppedFile>
}

/** Most bytes of a face with all files that it refers to: the same as for the commands (docs/auto-formats.md). */
const MOST_BYTES = 2 ** 29

/**
 * Reads a face: `.glb`, `.vrm` or `.gltf`, known by its contents. Files that it refers to are found by their paths and, where folders were
 * left out, by their names.
 *
 * @param dropped all files that were dropped.
 * @throws FurrowError when the file is not whole glTF 2.0, refers to a file that was not dropped, or is too large.
 */
export async function readFaceFile(face: DroppedFile, dropped: readonly DroppedFile[]): Promise<FaceFile> {
  checkBytes(face, [])
  const bytes = await bytesOf(face.file, face.path)
  const json = jsonOf(bytes, face.path)
  const references = new Map<string, DroppedFile>()
  for (const { uri } of [...(json.buffers ?? []), ...(json.images ?? [])]) {
    if (uri !== undefined && !/^data:/i.test(uri)) references.set(uri, referenced(face, uri, dropped))
  }
  const fileBytes = checkBytes(face, references.values())
  const problem = costProblem(json, fileBytes)
  if (problem) throw unusable(face.path, 'Studio', problem)
  return { bytes, json, references }
}

// glTF 2.0, section 4.4 (GLB file format): a header of 12 bytes, then chunks of 8 bytes and their data. JSON is the first.
const MAGIC = 0x46546c67
const JSON_START = 20

function jsonOf(bytes: Uint8Array, path: string): GltfJson {
  const fail = (problem: string, remedy?: string) => unusable(path, 'Studio', problem, { remedy })
  const text = new TextDecoder()
  let json: Uint8Array = bytes
  if (!/^\s*\{/.test(text.decode(bytes.subarray(0, 64)))) {
    const view = new DataView(bytes.buffer)
    const other = otherFormat(bytes)
    if (other) throw fail(other.problem, other.remedy)
    if (bytes.length < JSON_START || view.getUint32(0, true) !== MAGIC)
      throw fail('it does not begin with "glTF"')
    if (view.getUint32(4, true) !== 2) throw fail(`it has version ${view.getUint32(4, true)}`)
    const length = view.getUint32(8, true)
    if (length > bytes.length) throw fail(`it is cut off: ${bytes.length} of ${length} bytes`)
    json = bytes.subarray(JSON_START, JSON_START + view.getUint32(12, true))
  }
  let parsed: GltfJson
  try {
    parsed = JSON.parse(text.decode(json))
  } catch (error) {
    throw fail(`its JSON is malformed (${(error as Error).message})`)
  }
  const wrong = shapeProblem(parsed)
  if (wrong) throw fail(wrong)
  return parsed
}

/** @returns the bytes of all files together. */
function checkBytes(face: DroppedFile, references: Iterable<DroppedFile>): number {
  const files = new Set([face.file, ...[...references].map(({ file }) => file)])
  const bytes = [...files].reduce((sum, { size }) => sum + size, 0)
  if (bytes <= MOST_BYTES) return bytes
  throw new FurrowError({
    code: 'out-of-range',
    who: 'Studio',
    what: `${face.path} is too large`,
    value: `${Math.ceil(bytes / 2 ** 20)} MiB`,
    limit: `${MOST_BYTES / 2 ** 20} MiB with all files that it refers to`,
    remedy: 'compress its textures and meshes, for example with gltf-transform optimize',
  })
}

/** The file that a URI means: at its path, else the only one whose path ends with it or with its name. */
function referenced(face: DroppedFile, uri: string, dropped: readonly DroppedFile[]): DroppedFile {
  if (/^[a-z][a-z\d+.-]*:/i.test(uri)) throw elsewhere(face, uri)
  const path = normalized(`${folderOf(face.path)}${unescaped(uri)}`)
  const exact = dropped.find((file) => file.path === path)
  if (exact) return exact
  const name = path.split('/').at(-1)!.toLowerCase()
  const found = dropped.filter((file) => file.path.split('/').at(-1)!.toLowerCase() === name)
  if (found.length === 1) return found[0]
  throw missing(face, uri, found.length)
}

function folderOf(path: string): string {
  return path.slice(0, path.lastIndexOf('/') + 1)
}

/** A path without `.` and `..`, with `/`. */
function normalized(path: string): string {
  const parts: string[] = []
  for (const part of path.replaceAll('\\', '/').split('/')) {
    if (part === '..') parts.pop()
    else if (part !== '.' && part !== '') parts.push(part)
  }
  return parts.join('/')
}

/** Exporters are asked to escape URIs, and not all do. */
function unescaped(uri: string): string {
  try {
    return decodeURIComponent(uri)
  } catch {
    return uri
  }
}

function elsewhere({ path }: DroppedFile, uri: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who: 'Studio',
    what: `${path} refers to a file that is not on this computer`,
    value: uri,
    limit: 'paths relative to the file',
    remedy: 'download it, and correct the path in the file',
  })
}

function missing({ path }: DroppedFile, uri: string, count: number): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who: 'Studio',
    what: `${path} refers to ${count === 0 ? 'a file that was not dropped' : `one of ${count} files of the same name`}`,
    value: uri,
    remedy: 'drop the folder that has both',
  })
}
