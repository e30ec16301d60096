import { bytesOf } from '../files/dropped-files.ts'
import type { FaceFiles } from '../files/face-files.ts'
import type { OpenedAvatar } from '../open/avatar.ts'

/** Reads the files of an avatar. Rejects with a FurrowError if a file can no longer be read. */
export async function faceFilesOf({ files }: OpenedAvatar): Promise<FaceFiles> {
  const [face, ...others] = files
  const folder = face.path.slice(0, face.path.lastIndexOf('/') + 1)
  const references = others.map(async ({ path, file }): Promise<[string, Uint8Array]> => {
    return [path.startsWith(folder) ? path.slice(folder.length) : path, await bytesOf(file, path)]
  })
  return {
    name: face.path.slice(folder.length),
    bytes: await bytesOf(face.file, face.path),
    references: new Map(await Promise.all(references)),
  }
}
