import { type UnzipFileInfo, unzip, Zip, ZipDeflate, ZipPassThrough } from 'fflate'
import { FurrowError } from 'furrow'
import { bytesOf } from './dropped-files.ts'
import type { AvatarFile, FolderFile } from './folder-files.ts'

/** Most bytes that the files of an archive may have when they are unpacked. */
const MOST_BYTES = 2 ** 30

/** What is text: images and faces are compressed already, or too large to compress while someone waits. */
const TEXT = /\.(json|gltf)$/i

/** A folder as one .zip file, with all files in a folder of its name. */
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
 * The files of a .zip, with their paths; a folder that all of them are in is left out of these.
 *
 * @throws FurrowError when it is damaged, or too large.
 */
export async function unzipFolder(file: Blob, name: string): Promise<AvatarFile[]> {
  if (file.size > MOST_BYTES) throw tooLarge(name)
  const bytes = await bytesOf(file, name)
  let total = 0
  const filter = ({ name: path, originalSize }: UnzipFileInfo) => {
    if (path.endsWith('/') || isLeftBehind(path)) return false
    total += originalSize
    if (total > MOST_BYTES) throw tooLarge(name)
    return true
  }
  const files = await new Promise<Record<string, Uint8Array>>((resolve, reject) => {
    try {
      unzip(bytes, { filter }, (error, unpacked) => (error ? reject(error) : resolve(unpacked)))
    } catch (error) {
      reject(error)
    }
  }).catch((error) => {
    throw error instanceof FurrowError ? error : damaged(name, error)
  })
  const paths = Object.keys(files)
  const root = rootOf(paths)
  return paths.map((path) => ({
    path: path.slice(root.length),
    file: new Blob([files[path] as Uint8Array<ArrayBuffer>]),
  }))
}

/** The folder that all files are in, with its `/`; empty where there is none. */
function rootOf(paths: readonly string[]): string {
  const root = paths[0]?.match(/^[^/]+\//)?.[0] ?? ''
  return paths.every((path) => path.startsWith(root)) ? root : ''
}

/** What systems leave in archives. */
function isLeftBehind(path: string): boolean {
  return path.startsWith('__MACOSX/') || /(^|\/)\.[^/]*$/.test(path)
}

function tooLarge(name: string): FurrowError {
  return new FurrowError({
    code: 'out-of-range',
    who: 'Studio',
    what: `${name} is too large`,
    limit: `${MOST_BYTES / 2 ** 20} MB unpacked`,
    remedy: 'unpack it, and open the folder',
  })
}

function damaged(name: string, cause: Error): FurrowError {
  const what = `cannot read ${name} (${cause.message})`
  return new FurrowError(
    { code: 'unreadable', who: 'Studio', what, remedy: 'save or download it again' },
    { cause },
  )
}
