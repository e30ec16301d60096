import { type AutoPreset, parseAutoPreset } from 'furrow/author'
import { checkFileBytes, MAX_JSON_BYTES, parseJson } from 'furrow-files'
import { bytesOf, type DroppedFile } from '../files/dropped-files.ts'

/** Reads a preset of automatic wrinkles. Rejects with a FurrowError if the file is not a valid preset. */
export async function readPreset({ path, file }: DroppedFile): Promise<AutoPreset> {
  checkFileBytes(file.size, path, 'Studio', MAX_JSON_BYTES)
  return parseAutoPreset(parseJson(await bytesOf(file, path), path, 'Studio'), `Studio: ${path}`)
}
