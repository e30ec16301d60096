import { FurrowError } from 'furrow'
import { fromBase64, fromLatin1 } from './bytes.ts'
import { cannotRead } from './errors.ts'

/** Data of a URI in a glTF file. */
export interface Reference {
  bytes: Uint8Array
  /** Absolute path without symbolic links. Undefined for data URIs. */
  path?: string
}

/** Reads the data of a URI, or returns it from a cache. Throws if the data cannot be read. */
export type ReadReference = (uri: string) => Promise<Reference>

const SCHEME = /^[a-z][a-z\d+.-]*:/i
const DATA_URI = /^data:[^,]*?(;base64)?,/i

/** Returns the data of a `data:` URI, or undefined for other URIs. */
export function dataOf(uri: string): Uint8Array | undefined {
  const found = DATA_URI.exec(uri)
  if (!found) return undefined
  const text = uri.slice(found[0].length)
  return found[1] ? fromBase64(text) : fromLatin1(unescaped(text))
}

/**
 * Decodes a URI to a path with `/` as separator.
 *
 * @param file path of the file that contains the URI, for errors.
 * @throws FurrowError if the URI is empty, has a scheme such as `https:`, or contains a NUL character.
 */
export function pathOf(file: string, uri: string, who: string): string {
  if (!SCHEME.test(uri)) {
    const path = unescaped(uri).replaceAll('\\', '/')
    if (path === '') throw invalidUri(file, uri, who, 'an empty URI')
    if (path.includes('\0')) throw invalidUri(file, uri, who, 'a URI with a NUL character')
    return path
  }
  if (/^data:/i.test(uri)) throw invalidUri(file, uri, who, 'a data URI without a comma before its data')
  if (/^file:/i.test(uri)) throw outside(file, uri, who)
  throw new FurrowError({
    code: 'unreadable',
    who,
    problem: `${file} references a remote file`,
    value: uri,
    limit: 'paths relative to the file',
    remedy: 'download the referenced file into the same folder',
  })
}

/**
 * Decodes percent escapes. Returns the text unchanged if an escape is invalid, because some exporters do not encode
 * URIs.
 */
export function unescaped(text: string): string {
  try {
    return decodeURIComponent(text)
  } catch {
    return text
  }
}

/** Removes empty parts, `.` and `..` from a relative path. Keeps leading `..`. */
export function normalised(path: string): string {
  const parts: string[] = []
  for (const part of path.split('/')) {
    if (part === '' || part === '.') continue
    if (part === '..' && parts.length > 0 && parts.at(-1) !== '..') parts.pop()
    else parts.push(part)
  }
  return parts.join('/')
}

export function outside(file: string, uri: string, who: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who,
    problem: `${file} references a file outside its folder`,
    value: uri,
    limit: 'files in the same folder or below',
    remedy: 'move the referenced file, or allow it with --allow-outside',
  })
}

export function missing(file: string, uri: string, who: string, error: unknown): FurrowError {
  return cannotRead(who, `${printable(uri)}, referenced by ${file}`, error, {
    remedy: 'add the file, or correct the URI',
  })
}

export const printable = (uri: string) => (uri.length > 120 ? `${uri.slice(0, 117)}...` : uri)

function invalidUri(file: string, uri: string, who: string, description: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who,
    problem: `${file} has ${description}`,
    value: uri,
    limit: 'paths relative to the file',
    remedy: 'correct the URI',
  })
}
