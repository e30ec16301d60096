import { decodeGray } from 'furrow-files'
import type { StudioDocument } from '../document/document.ts'
import type { FaceFiles } from '../files/face-files.ts'
import type { AvatarFile } from '../files/folder-files.ts'
import { type ReadFolder, readFolder } from '../keep/read-folder.ts'
import { readFace } from './read-face.ts'

/**
 * Reads the wrinkles of a face as a document.
 *
 * @param material name of the wrinkled material, required if there are several.
 * @returns null if the face has no wrinkles.
 * @throws FurrowError as `readFace` and `readFolder` do.
 */
export async function readDocument(file: FaceFiles, material?: string): Promise<StudioDocument | null> {
  const { folder } = await readFace(file, material === undefined ? {} : { material })
  if (!folder) return null
  const files = [...folder].map(([path, bytes]) => ({ path, file: new Blob([bytes as BlobPart]) }))
  const { document } = await readProject(files, file.name)
  return document
}

/** Reads a project folder, the input of `furrow pack`; see `readFolder`. */
export function readProject(files: readonly AvatarFile[], name: string): Promise<ReadFolder> {
  return readFolder(files, name, decodeGray)
}
