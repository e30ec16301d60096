import { createHash, type Hash } from 'node:crypto'
import { createReadStream, type Dirent } from 'node:fs'
import { readdir } from 'node:fs/promises'
import { basename, join, relative, sep } from 'node:path'
import { FurrowError } from 'furrow'
import { cannotRead, dataOf, MAX_JSON_BYTES, parseJson, WRINKLES_FILE } from 'furrow-files'
import { fileProblem, readBytes, resolveInside, statOf } from 'furrow-files/node'
import { writeAll } from '../../files.ts'
import type { FileStore } from './file-store.ts'

const WHO = 'furrow batch'

/** Store of local files and folders. Several machines may share the disk. */
export const files: FileStore = {
  async identify(path, reads) {
    try {
      const hash = createHash('sha256')
      if (reads === 'folder') await addFolder(hash, path)
      else await addFace(hash, path)
      return `sha256:${hash.digest('hex')}`
    } catch (error) {
      throw error instanceof FurrowError ? error : cannotRead(WHO, path, error)
    }
  },
  async fetch(path, identity, reads) {
    if ((await this.identify(path, reads)) === identity) return path
    throw changedInput(path)
  },
  read: (path) => readBytes(path, WHO),
  // The batch has already checked that outputs overwrite no inputs.
  put: (path, bytes) => writeAll([{ path, bytes }], WHO, { updated: [path] }),
  async sizeOf(path) {
    return (await statOf(path))?.size
  },
}

/** Creates the error for an input whose content has changed since the job was created. */
export function changedInput(address: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who: WHO,
    problem: `${address} has changed since the batch started`,
    remedy: 'run the batch again',
  })
}

async function addFile(hash: Hash, path: string): Promise<void> {
  // `stream.pipeline` would add listeners to the hash for each file, and never remove them.
  for await (const chunk of createReadStream(path)) hash.update(chunk)
}

/**
 * Adds a glTF file to a hash. For a `.gltf`, also adds the referenced files in its folder. Skips missing files, because
 * the command reports them.
 */
async function addFace(hash: Hash, path: string): Promise<void> {
  const problem = fileProblem(await statOf(path))
  if (problem) throw cannotRead(WHO, path, problem, { remedy: "give files, e.g. 'avatars/**/*.glb'" })
  await addFile(hash, path)
  if (!path.toLowerCase().endsWith('.gltf')) return
  for (const uri of await urisOf(path)) {
    const file = await resolveInside(path, uri, WHO).catch(() => undefined)
    hash.update(`\0${uri}\0`)
    if (file !== undefined) await addFile(hash, file)
  }
}

/** Returns the URIs in a `.gltf`, except data URIs. Returns none for an invalid file, because the command reports it. */
async function urisOf(path: string): Promise<string[]> {
  const { buffers, images } = Object(await readAnyJson(path))
  const uris: unknown[] = [buffers, images].flat().map((one) => Object(one).uri)
  return uris.filter((uri): uri is string => typeof uri === 'string' && !dataOf(uri))
}

async function readAnyJson(path: string): Promise<unknown> {
  try {
    return parseJson(await readBytes(path, WHO, '', { maxBytes: MAX_JSON_BYTES }), path, WHO)
  } catch {
    return undefined
  }
}

function stringsIn(value: unknown): string[] {
  if (typeof value === 'string') return [value]
  return typeof value === 'object' && value !== null ? Object.values(value).flatMap(stringsIn) : []
}

/**
 * Returns the paths of all files that a command may read for a local input. Includes the files that the input
 * references, even outside its folder.
 */
export async function filesRead(path: string, reads: 'file' | 'folder'): Promise<string[]> {
  const own = reads === 'file' ? [path] : (await entriesOf(path)).filter(isFileOrLink).map(pathIn)
  const lists = own.map(async (file) => {
    const isGltf = file.toLowerCase().endsWith('.gltf')
    if (!isGltf && basename(file) !== WRINKLES_FILE) return [file]
    const uris = isGltf ? await urisOf(file) : stringsIn(await readAnyJson(file))
    const found = uris.map((uri) => resolveInside(file, uri, WHO, { allowOutside: true }).catch(() => []))
    return [file, ...(await Promise.all(found)).flat()]
  })
  return (await Promise.all(lists)).flat()
}

const entriesOf = (folder: string) => readdir(folder, { recursive: true, withFileTypes: true })

const pathIn = ({ parentPath, name }: Dirent) => join(parentPath, name)

const isFileOrLink = (entry: Dirent) => entry.isFile() || entry.isSymbolicLink()

async function addFolder(hash: Hash, folder: string): Promise<void> {
  const paths = (await entriesOf(folder)).filter((entry) => entry.isFile()).map(pathIn)
  for (const path of paths.sort()) {
    hash.update(`\0${relative(folder, path).split(sep).join('/')}\0`)
    await addFile(hash, path)
  }
}
