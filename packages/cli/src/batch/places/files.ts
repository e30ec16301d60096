import { createHash, type Hash } from 'node:crypto'
import { createReadStream } from 'node:fs'
import { readdir } from 'node:fs/promises'
import { join, relative, sep } from 'node:path'
import { pipeline } from 'node:stream/promises'
import { FurrowError } from 'furrow'
import { cannotRead, dataOf, MAX_JSON_BYTES, parseJson } from 'furrow-files'
import { fileProblem, readBytes, resolveInside, statOf } from 'furrow-files/node'
import { writeAll } from '../../files.ts'
import type { Place } from './place.ts'

const WHO = 'furrow batch'

/** Files and folders of this machine, or of a disk that machines share. */
export const files: Place = {
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
    throw changed(path)
  },
  read: (path) => readBytes(path, WHO),
  put: (path, bytes) => writeAll([{ path, bytes }], WHO),
  async sizeOf(path) {
    return (await statOf(path))?.size
  },
}

/** The error for an input that is not the one that the job was made for. */
export function changed(address: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who: WHO,
    what: `${address} has changed since the batch began`,
    remedy: 'run the batch again',
  })
}

async function addFile(hash: Hash, path: string): Promise<void> {
  await pipeline(createReadStream(path), hash, { end: false })
}

/** A `.gltf` with the files of its folder that it refers to. The command tells of those that are missing, or elsewhere. */
async function addFace(hash: Hash, path: string): Promise<void> {
  const problem = fileProblem(await statOf(path))
  if (problem) throw cannotRead(WHO, path, problem, { remedy: "name files, e.g. 'avatars/**/*.glb'" })
  await addFile(hash, path)
  if (!path.toLowerCase().endsWith('.gltf')) return
  for (const uri of await urisOf(path)) {
    const file = await resolveInside(path, uri, WHO).catch(() => undefined)
    hash.update(`\0${uri}\0`)
    if (file !== undefined) await addFile(hash, file)
  }
}

/** What is wanted of a file that may hold anything. */
interface Gltf {
  buffers?: { uri?: unknown }[]
  images?: { uri?: unknown }[]
}

async function urisOf(path: string): Promise<string[]> {
  try {
    const { buffers = [], images = [] } = parseJson(
      await readBytes(path, WHO, '', { most: MAX_JSON_BYTES }),
      path,
      WHO,
    ) as Gltf
    const uris = [...buffers, ...images].map((one) => one?.uri)
    return uris.filter((uri): uri is string => typeof uri === 'string' && !dataOf(uri))
  } catch {
    // What is not glTF is refused by the command.
    return []
  }
}

async function addFolder(hash: Hash, folder: string): Promise<void> {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true })
  const paths = entries
    .filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => join(parentPath, name))
  for (const path of paths.sort()) {
    hash.update(`\0${relative(folder, path).split(sep).join('/')}\0`)
    await addFile(hash, path)
  }
}
