import { FurrowError } from 'furrow'
import { fromBase64, fromLatin1 } from './bytes.ts'
import { cannotRead } from './errors.ts'

/** What a URI refers to. */
export interface Reference {
  bytes: Uint8Array
  /** The path of the file, the same by whatever URI; undefined where the URI itself holds the data. */
  path?: string
}

/** Reads what a URI in a file refers to; the same object each time. Throws FurrowError where it cannot. */
export type ReadReference = (uri: string) => Promise<Reference>

const SCHEME = /^[a-z][a-z\d+.-]*:/i
const DATA_URI = /^data:[^,]*?(;base64)?,/i

/** The data in a `data:` URI; undefined for any other. */
export function dataOf(uri: string): Uint8Array | undefined {
  const found = DATA_URI.exec(uri)
  if (!found) return undefined
  const text = uri.slice(found[0].length)
  return found[1] ? fromBase64(text) : fromLatin1(unescaped(text))
}

/**
 * The path in a URI, with the separators of any system.
 *
 * @param file path of the file with the URI, for errors.
 * @throws FurrowError for anything that is not a relative path.
 */
export function pathOf(file: string, uri: string, who: string): string {
  if (!SCHEME.test(uri)) {
    const path = unescaped(uri).replaceAll('\\', '/')
    if (path === '') throw noAddress(file, uri, who, 'an empty address')
    if (path.includes('\0')) throw noAddress(file, uri, who, 'an address with a NUL character')
    return path
  }
  if (/^data:/i.test(uri)) throw noAddress(file, uri, who, 'a data address without a comma before its data')
  if (/^file:/i.test(uri)) throw outside(file, uri, who)
  throw new FurrowError({
    code: 'unreadable',
    who,
    problem: `${file} refers to a file that is not on this computer`,
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

/** A relative path without `.`, `..` and empty parts, except `..` at its beginning. */
export function normalised(path: string): string {
  const parts: string[] = []
  for (const part of path.split('/')) {
    if (part === '' || part === '.') continue
    if (part === '..' && parts.length > 0 && parts.at(-1) !== '..') parts.pop()
    else parts.push(part)
  }
  return parts.join('/')
}

/** The error for a reference that leads out of the folder of its file. */
export function outside(file: string, uri: string, who: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who,
    problem: `${file} refers to a file outside its folder`,
    value: uri,
    limit: 'files in the same folder, or below it',
    remedy: 'move it there, or trust the file with --allow-outside',
  })
}

/** The error for a reference to a file that cannot be read. */
export function missing(file: string, uri: string, who: string, error: unknown): FurrowError {
  return cannotRead(who, `${printable(uri)}, which ${file} refers to`, error, {
    remedy: 'put it there, or correct the address',
  })
}

export const printable = (uri: string) => (uri.length > 120 ? `${uri.slice(0, 117)}...` : uri)

function noAddress(file: string, uri: string, who: string, what: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who,
    problem: `${file} has ${what}`,
    value: uri,
    limit: 'paths relative to the file',
    remedy: 'correct the address',
  })
}
