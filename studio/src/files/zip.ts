import { Zip, ZipDeflate, ZipPassThrough } from 'fflate'
import { FurrowError } from 'furrow'
import { bytesOf, MAX_FILES, tooManyFilesError } from './dropped-files.ts'
import type { AvatarFile, FolderFile } from './folder-files.ts'
import { unpackEntry, type ZipEntry, zipEntries } from './read-zip.ts'

/** Maximum uncompressed bytes of an archive. */
const MAX_BYTES = 2 ** 30

/** Files to compress. Images are already compressed, and faces are too large to compress quickly. */
const TEXT = /\.(json|gltf)$/i

/** Makes a .zip archive that contains the files in one folder of this name. */
export async function zipFolder(files: readonly FolderFile[], name: string): Promise<Blob> {
  const parts: Uint8Array<ArrayBuffer>[] = []
  const zip = new Zip((error, chunk) => {
    if (error) throw error
    parts.push(chunk as Uint8Array<ArrayBuffer>)
  })
  for (const { path, content } of files) {
    const bytes = content instanceof Blob ? new Uint8Array(await content.arrayBuffer()) : content
    const entry = TEXT.test(path) ? new ZipDeflate(`${name}/${path}`) : new ZipPassThrough(`${name}/${path}`)
    zip.add(entry)
    entry.push(bytes, true)
  }
  zip.end()
  return new Blob(parts, { type: 'application/zip' })
}

/**
 * Unpacks a .zip archive. If one folder contains all files, removes this folder from their paths.
 *
 * @throws FurrowError if the archive is damaged, is too large, has too many files, or declares a wrong size.
 */
export async function unzipFolder(file: Blob, name: string): Promise<AvatarFile[]> {
  if (file.size > MAX_BYTES) throw tooLargeError(name)
  const bytes = await bytesOf(file, name)
  const files = new Map<string, Blob>()
  try {
    for (const entry of entriesOf(bytes, name)) files.set(entry.path, await unpackEntry(bytes, entry))
  } catch (error) {
    throw error instanceof FurrowError ? error : damagedError(name, error as Error)
  }
  const root = rootOf([...files.keys()])
  return [...files].map(([path, file]) => ({ path: path.slice(root.length), file }))
}

/** Lists the files to unpack. Throws FurrowError if there are too many, or if their declared size is too large. */
function entriesOf(bytes: Uint8Array, name: string): ZipEntry[] {
  const entries: ZipEntry[] = []
  let total = 0
  for (const entry of zipEntries(bytes)) {
    if (entry.path.endsWith('/') || isJunk(entry.path)) continue
    total += entry.length
    if (total > MAX_BYTES) throw tooLargeError(name)
    if (entries.length === MAX_FILES) throw tooManyFilesError(name)
    entries.push(entry)
  }
  return entries
}

/** Returns the common root folder with its `/`, or an empty string. */
function rootOf(paths: readonly string[]): string {
  const root = paths[0]?.match(/^[^/]+\//)?.[0] ?? ''
  return paths.every((path) => path.startsWith(root)) ? root : ''
}

/** Whether a file is hidden, or was added by macOS. */
function isJunk(path: string): boolean {
  return path.startsWith('__MACOSX/') || /(^|\/)\.[^/]*$/.test(path)
}

function tooLargeError(name: string): FurrowError {
  return new FurrowError({
    code: 'out-of-range',
    who: 'Studio',
    problem: `${name} is too large`,
    limit: `${MAX_BYTES / 2 ** 20} MB unpacked`,
    remedy: 'unpack it, and open the folder',
  })
}

function damagedError(name: string, cause: Error): FurrowError {
  // DataView throws a RangeError for offsets outside the archive.
  const reason = cause instanceof RangeError ? 'it is cut off or damaged' : cause.message
  const problem = `cannot read ${name} (${reason})`
  return new FurrowError(
    { code: 'unreadable', who: 'Studio', problem, remedy: 'save or download it again' },
    { cause },
  )
}
