import { readFile, realpath, stat } from 'node:fs/promises'
import { dirname, isAbsolute, relative, resolve, sep } from 'node:path'
import { fileURLToPath } from 'node:url'
import { FurrowError } from 'furrow'
import { cannotRead } from '../errors.ts'
import { checkFileBytes } from '../inputs.ts'

/** Which files besides the named one a command may read. */
export interface ReadOptions {
  /** Whether a file may refer to files outside its own folder. */
  allowOutside?: boolean | undefined
}

const SCHEME = /^[a-z][a-z\d+.-]*:/i
const DATA_URI = /^data:[^,]*?(;base64)?,/i

/**
 * Finds the file that a URI in another file refers to. Symbolic links are followed before it is checked where it is.
 *
 * @param file path of the file with the URI.
 * @returns the real path of a regular file.
 * @throws FurrowError when it is missing, not a regular file, too large, on the network, or outside the folder of `file`.
 */
export async function resolveInside(
  file: string,
  uri: string,
  who: string,
  { allowOutside = false }: ReadOptions = {},
): Promise<string> {
  const folder = dirname(resolve(file))
  const target = resolve(folder, pathOf(file, uri, who, allowOutside))
  // Before links are followed, so that nobody learns from the error whether a file elsewhere exists.
  if (!allowOutside && !isInside(folder, target)) throw outside(file, uri, who)
  const real = await realpath(target).catch((error) => {
    throw missing(file, uri, who, error)
  })
  if (!allowOutside && !isInside(await realpath(folder), real)) throw outside(file, uri, who)
  const found = await stat(real)
  if (!found.isFile()) throw missing(file, uri, who, new Error('it is not a file'))
  checkFileBytes(found.size, `${printable(uri)}, which ${file} refers to,`, who)
  return real
}

/** What a URI refers to. */
export interface Reference {
  bytes: Uint8Array
  /** The real path of the file; undefined where the URI itself holds the data. */
  path?: string
}

/**
 * Returns what reads the references of a file: files, see `resolveInside`, and the data in `data:` URIs. Each is read
 * once, and is the same object by whatever URI.
 *
 * @param file path of the file with the URIs.
 * @returns a function that throws FurrowError when a reference cannot be read, or all together are too large.
 */
export function referenceReader(
  file: string,
  who: string,
  options: ReadOptions = {},
): (uri: string) => Promise<Reference> {
  const known = new Map<string, Reference>()
  let total = 0
  const readAt = async (path: string, uri: string): Promise<Reference> => {
    total += (await stat(path)).size
    checkFileBytes(total, `${file} with the files that it refers to`, who)
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

/** The data in a `data:` URI; undefined for any other. */
function dataOf(uri: string): Uint8Array | undefined {
  const found = DATA_URI.exec(uri)
  if (!found) return undefined
  const text = uri.slice(found[0].length)
  return found[1] ? Buffer.from(text, 'base64') : Buffer.from(unescaped(text), 'latin1')
}

/** The path in a URI, with the separators of any system. Throws FurrowError for anything that is not a path. */
function pathOf(file: string, uri: string, who: string, allowOutside: boolean): string {
  if (!SCHEME.test(uri)) {
    const path = unescaped(uri).replaceAll('\\', '/')
    if (path === '') throw noAddress(file, uri, who, 'an empty address')
    if (path.includes('\0')) throw noAddress(file, uri, who, 'an address with a NUL character')
    return path
  }
  if (/^data:/i.test(uri)) throw noAddress(file, uri, who, 'a data address without a comma before its data')
  if (/^file:/i.test(uri)) {
    if (!allowOutside) throw outside(file, uri, who)
    try {
      return fileURLToPath(uri)
    } catch (error) {
      throw missing(file, uri, who, error)
    }
  }
  throw new FurrowError({
    code: 'unreadable',
    who,
    what: `${file} refers to a file that is not on this computer`,
    value: uri,
    limit: 'paths relative to the file',
    remedy: 'download it, and put it beside the file',
  })
}

/** A URI without its escapes. Exporters are asked to escape URIs, and not all do. */
export function unescaped(text: string): string {
  try {
    return decodeURIComponent(text)
  } catch {
    return text
  }
}

function isInside(folder: string, path: string): boolean {
  const way = relative(folder, path)
  return !isAbsolute(way) && way !== '..' && !way.startsWith(`..${sep}`)
}

function outside(file: string, uri: string, who: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who,
    what: `${file} refers to a file outside its folder`,
    value: uri,
    limit: 'files in the same folder, or below it',
    remedy: 'move it there, or trust the file with --allow-outside',
  })
}

function noAddress(file: string, uri: string, who: string, what: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who,
    what: `${file} has ${what}`,
    value: uri,
    limit: 'paths relative to the file',
    remedy: 'correct the address',
  })
}

function missing(file: string, uri: string, who: string, error: unknown): FurrowError {
  return cannotRead(who, `${printable(uri)}, which ${file} refers to`, error, {
    remedy: 'put it there, or correct the address',
  })
}

const printable = (uri: string) => (uri.length > 120 ? `${uri.slice(0, 117)}...` : uri)
