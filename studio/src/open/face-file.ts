import { FurrowError } from 'furrow'
import {
  checkFileBytes,
  costProblem,
  decodeGlb,
  type GltfJson,
  normalised,
  pathOf,
  unusable,
} from 'furrow-files'
import { bytesOf, type DroppedFile } from '../files/dropped-files.ts'

/** glTF file with its parsed JSON, and the files that it references. */
export interface FaceFile {
  bytes: Uint8Array<ArrayBuffer>
  json: GltfJson
  /** Referenced files. The keys are URIs in the glTF file. */
  references: ReadonlyMap<string, DroppedFile>
}

const WHO = 'Studio'

/**
 * Reads the file of a face: `.glb`, `.vrm` or `.gltf`. Detects the format by content, not by extension. Finds referenced files by path, or by name if
 * their folders are missing.
 *
 * @param dropped all dropped files.
 * @throws FurrowError if the file is not valid glTF 2.0, a referenced file is missing, or the files are too large.
 */
export async function readFaceFile(face: DroppedFile, dropped: readonly DroppedFile[]): Promise<FaceFile> {
  checkFileBytes(face.file.size, face.path, WHO)
  const bytes = await bytesOf(face.file, face.path)
  const { json } = decodeGlb(bytes, face.path, WHO)
  const references = new Map<string, DroppedFile>()
  for (const { uri } of [...(json.buffers ?? []), ...(json.images ?? [])]) {
    if (uri !== undefined && !/^data:/i.test(uri)) references.set(uri, referenced(face, uri, dropped))
  }
  const files = new Set([face.file, ...[...references.values()].map(({ file }) => file)])
  const fileBytes = [...files].reduce((sum, { size }) => sum + size, 0)
  checkFileBytes(fileBytes, `${face.path} with the files that it refers to`, WHO)
  const problem = costProblem(json, fileBytes)
  if (problem) throw unusable(face.path, WHO, problem)
  return { bytes, json, references }
}

/** Finds the file to which a URI refers: the file at this path, or else the only file with this name. */
function referenced(face: DroppedFile, uri: string, dropped: readonly DroppedFile[]): DroppedFile {
  const path = normalised(`${folderOf(face.path)}${pathOf(face.path, uri, WHO)}`)
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

function missing({ path }: DroppedFile, uri: string, count: number): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who: WHO,
    problem: `${path} refers to ${count === 0 ? 'a file that was not dropped' : `one of ${count} files of the same name`}`,
    value: uri,
    remedy: 'drop the folder that has both',
  })
}
