import { readFile, realpath, stat } from 'node:fs/promises'
import { dirname, isAbsolute, relative, resolve, sep } from 'node:path'
import { fileURLToPath } from 'node:url'
import { checkFileBytes } from '../base/file-size.ts'
import {
  dataOf,
  missing,
  outside,
  pathOf,
  printable,
  type ReadReference,
  type Reference,
} from '../base/references.ts'
import { recordRead } from './files-read.ts'

/** Options for reading a file that may reference other files. */
export interface ReadOptions {
  /** Whether the file may reference files outside its folder. Default false. */
  allowOutside?: boolean | undefined
}

/**
 * Resolves a URI in a file to a path. Unless `allowOutside` is set, the path must be inside the folder of `file`. This
 * holds for the path as written, and for the path after symbolic links are followed.
 *
 * @param file path of the file that contains the URI.
 * @returns absolute path of a regular file.
 * @throws FurrowError if the file is missing, not a regular file, too large, remote, or outside the folder without
 *   `allowOutside`.
 */
export async function resolveInside(
  file: string,
  uri: string,
  who: string,
  { allowOutside = false }: ReadOptions = {},
): Promise<string> {
  const folder = dirname(resolve(file))
  const isUrl = allowOutside && /^file:/i.test(uri)
  const target = resolve(folder, isUrl ? pathOfUrl(file, uri, who) : pathOf(file, uri, who))
  // The first check comes before any access, so that the error does not reveal whether a file outside the folder
  // exists.
  if (!allowOutside && !isInside(folder, target)) throw outside(file, uri, who)
  const real = await realpath(target).catch((error) => {
    throw missing(file, uri, who, error)
  })
  if (!allowOutside && !isInside(await realpath(folder), real)) throw outside(file, uri, who)
  const found = await stat(real)
  if (!found.isFile()) throw missing(file, uri, who, new Error('it is not a file'))
  checkFileBytes(found.size, `${printable(uri)}, referenced by ${file},`, who)
  return real
}

/**
 * Returns a function that reads the data of a URI: a file (see `resolveInside`) or a `data:` URI. Caches the results by
 * path.
 *
 * @param file path of the file that contains the URIs.
 * @returns a function that throws FurrowError if a file cannot be read, or if all files together are too large.
 */
export function referenceReader(file: string, who: string, options: ReadOptions = {}): ReadReference {
  const known = new Map<string, Reference>()
  let total = 0
  const readAt = async (path: string, uri: string): Promise<Reference> => {
    const found = await stat(path, { bigint: true })
    recordRead(found)
    total += Number(found.size)
    checkFileBytes(total, `${file} with its referenced files`, who)
    try {
      return { bytes: await readFile(path), path }
    } catch (error) {
      throw missing(file, uri, who, error)
    }
  }
  return async (uri) => {
    const data = dataOf(uri)
    const key = data ? uri : await resolveInside(file, uri, who, options)
    const reference = known.get(key) ?? (data ? { bytes: data } : await readAt(key, uri))
    known.set(key, reference)
    return reference
  }
}

function pathOfUrl(file: string, uri: string, who: string): string {
  try {
    return fileURLToPath(uri)
  } catch (error) {
    throw missing(file, uri, who, error)
  }
}

function isInside(folder: string, path: string): boolean {
  const relativePath = relative(folder, path)
  return !isAbsolute(relativePath) && relativePath !== '..' && !relativePath.startsWith(`..${sep}`)
}
