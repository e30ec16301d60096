import {
  checkFileBytes,
  dataOf,
  type Glb,
  missing,
  normalised,
  openGlb,
  pathOf,
  type ReadReference,
  type Reference,
} from 'furrow-files'

/** Files by path relative to a folder, with `/`. */
export type Files = ReadonlyMap<string, Uint8Array>

/** Original face file and the files that it references, by path or by URI. */
export interface FaceFiles {
  name: string
  bytes: Uint8Array
  references?: Files
}

/** Opens a face like the commands. Throws FurrowError as `openGlb` does. */
export async function openFace(
  { name, bytes, references = new Map() }: FaceFiles,
  who: string,
): Promise<Glb> {
  checkFileBytes(bytes.length, name, who)
  return openGlb(bytes, name, who, referencesIn(references, name, who))
}

/**
 * Returns a reader for the references of a file.
 *
 * @param files files by path relative to the folder of the file, or by URI.
 * @param file name of the file with the references, for errors.
 */
export function referencesIn(files: Files, file: string, who: string): ReadReference {
  const known = new Map<string, Reference>()
  const readAt = (path: string, uri: string): Reference => {
    const bytes = files.get(path) ?? files.get(uri)
    if (!bytes) throw missing(file, uri, who, new Error('it was not opened with it'))
    return { bytes, path }
  }
  return async (uri) => {
    const data = dataOf(uri)
    const path = data ? undefined : pathOf(file, uri, who)
    const key = path === undefined ? uri : normalised(path)
    const reference = known.get(key) ?? (data ? { bytes: data } : readAt(key, uri))
    known.set(key, reference)
    return reference
  }
}
