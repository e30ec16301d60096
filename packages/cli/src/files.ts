import { mkdir, open, readdir, readFile, rename, rm, rmdir, stat, writeFile } from 'node:fs/promises'
import { basename, dirname, join, resolve } from 'node:path'
import { FurrowError } from 'furrow'
import { cannotRead, cannotWrite } from './errors.ts'

/** A file to write: its whole content, still in memory. */
export interface OutputFile {
  path: string
  bytes: Uint8Array
}

/**
 * Reads a file.
 *
 * @param noun what the file is to the user, e.g. `the face`; put before its path in the error.
 * @throws FurrowError when it cannot be read.
 */
export async function readBytes(path: string, who: string, noun = '', remedy?: string): Promise<Buffer> {
  try {
    return await readFile(path)
  } catch (error) {
    throw cannotRead(who, `${noun} ${path}`.trim(), error, remedy === undefined ? {} : { remedy })
  }
}

/** Reads a JSON file; see `readBytes`. Throws FurrowError also when it is not JSON. */
export async function readJson(path: string, who: string, noun = '', remedy?: string): Promise<unknown> {
  const bytes = await readBytes(path, who, noun, remedy)
  try {
    return JSON.parse(bytes.toString())
  } catch (error) {
    throw cannotRead(who, `${noun} ${path}`.trim(), error, { limit: 'JSON', remedy: 'correct the file' })
  }
}

/**
 * Checks that a file can be written before any work is done for it. Leaves nothing behind.
 *
 * @param extension what its name must end with.
 * @throws FurrowError when it cannot.
 */
export async function checkWritable(path: string, who: string, extension = '.png'): Promise<void> {
  if (!path.toLowerCase().endsWith(extension)) {
    const problem = `its name does not end in ${extension}`
    throw cannotWrite(who, path, problem, `name it e.g. face${extension}`)
  }
  try {
    if ((await stat(path).catch(() => undefined))?.isDirectory()) throw new Error('it is a folder')
    const folder = await nearestFolder(dirname(resolve(path)))
    const trial = temporaryPath(join(folder, basename(path)))
    await (await open(trial, 'wx')).close()
    await rm(trial)
  } catch (error) {
    throw cannotWrite(who, path, error)
  }
}

/**
 * Writes all files or none: everything goes to temporary files beside their targets first, which are then renamed.
 * Creates missing folders.
 *
 * @throws FurrowError naming the file that cannot be written.
 */
export async function writeAll(outputs: readonly OutputFile[], who: string): Promise<void> {
  let current = ''
  try {
    for (const { path, bytes } of outputs) {
      current = path
      await mkdir(dirname(path), { recursive: true })
      await writeFile(temporaryPath(path), bytes)
    }
    for (const { path } of outputs) {
      current = path
      await rename(temporaryPath(path), path)
    }
  } catch (error) {
    await Promise.all(outputs.map(({ path }) => rm(temporaryPath(path), { force: true }).catch(() => {})))
    throw cannotWrite(who, current, error)
  }
}

/** Writes a new folder whole or not at all: it is filled under a temporary name beside it, then renamed. */
export async function writeFolder(
  folder: string,
  outputs: readonly OutputFile[],
  who: string,
): Promise<void> {
  const target = resolve(folder)
  const temporary = temporaryPath(target)
  try {
    await writeAll(
      outputs.map(({ path, bytes }) => ({ path: join(temporary, path), bytes })),
      who,
    )
    // Removes only an empty folder; otherwise the rename fails and nothing of the user's is lost.
    await rmdir(target).catch(() => {})
    await rename(temporary, target)
  } catch (error) {
    await rm(temporary, { recursive: true, force: true }).catch(() => {})
    throw error instanceof FurrowError ? error : cannotWrite(who, folder, error)
  }
}

/** Throws FurrowError where a path that is to become a folder is a file. */
export async function checkFolder(path: string, who: string): Promise<void> {
  const found = await stat(path).catch(() => undefined)
  if (!found || found.isDirectory()) return
  throw new FurrowError({ code: 'unwritable', who, what: `${path} is not a folder`, remedy: 'name a folder' })
}

/** Throws FurrowError where a path is a file or a folder with contents. */
export async function checkNewFolder(path: string, who: string): Promise<void> {
  const found = await stat(path).catch(() => undefined)
  if (!found) return
  if (found.isDirectory() && (await readdir(path)).length === 0) return
  throw new FurrowError({
    code: 'unwritable',
    who,
    what: `${path} is ${found.isDirectory() ? 'not empty' : 'a file'}`,
    limit: 'a new or an empty folder',
    remedy: 'name another one; nothing is overwritten',
  })
}

const temporaryPath = (path: string) => `${path}.${process.pid}.tmp`

/** The folder itself, or its nearest ancestor that exists. */
async function nearestFolder(path: string): Promise<string> {
  const found = await stat(path).catch(() => undefined)
  if (found?.isDirectory()) return path
  if (found) throw new Error(`${path} is not a folder`)
  const parent = dirname(path)
  if (parent === path) throw new Error(`${path} does not exist`)
  return nearestFolder(parent)
}
