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

/** Files by their paths below a folder, with `/`. */
export type Files = ReadonlyMap<string, Uint8Array>

/** A face as it was opened: its file, and those that it refers to, by their paths or by the URIs in it. */
export interface FaceFiles {
  name: string
  bytes: Uint8Array
  references?: Files
}

/** Opens a face as the commands read one. Throws FurrowError as `openGlb` does. */
export async function openFace(
  { name, bytes, references = new Map() }: FaceFiles,
  who: string,
): Promise<Glb> {
  checkFileBytes(bytes.length, name, who)
  return openGlb(bytes, name, who, referencesIn(references, name, who))
}

/**
 * Returns what reads the references of a file among other files.
 *
 * @param files by their paths below the folder of the file, or by the URIs in it.
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
