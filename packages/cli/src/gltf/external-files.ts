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

/**
 * Reads what a URI in a file refers to: a file, see `resolveInside`, or the data in a `data:` URI.
 *
 * @throws FurrowError when it cannot be read.
 */
export async function readUri(
  file: string,
  uri: string,
  who: string,
  options: ReadOptions = {},
): Promise<Uint8Array> {
  const data = DATA_URI.exec(uri)
  if (data) {
    const text = uri.slice(data[0].length)
    return data[1] ? Buffer.from(text, 'base64') : Buffer.from(unescaped(text), 'latin1')
  }
  const path = await resolveInside(file, uri, who, options)
  try {
    return await readFile(path)
  } catch (error) {
    throw missing(file, uri, who, error)
  }
}

/** The path in a URI, with the separators of any system. Throws FurrowError for anything that is no path. */
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

/** Exporters are asked to escape URIs, and not all do. */
function unescaped(text: string): string {
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
