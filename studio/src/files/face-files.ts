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

/** Contents of files. The keys are paths relative to a folder, with `/`. */
export type Files = ReadonlyMap<string, Uint8Array>

/** glTF file of a face, and the files that it references. The keys of `references` are paths or URIs. */
export interface FaceFiles {
  name: string
  bytes: Uint8Array
  references?: Files
}

/** Opens a face as the command line does. Throws FurrowError in the same cases as `openGlb`. */
export async function openFace(
  { name, bytes, references = new Map() }: FaceFiles,
  who: string,
): Promise<Glb> {
  checkFileBytes(bytes.length, name, who)
  return openGlb(bytes, name, who, referencesIn(references, name, who))
}

/**
 * Returns a function that reads the files to which a glTF file refers.
 *
 * @param files available files. The keys are URIs, or paths relative to the folder of the glTF file.
 * @param file name of the glTF file, for errors.
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
