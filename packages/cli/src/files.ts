import { existsSync, mkdirSync, renameSync, rmdirSync, rmSync, type Stats, writeFileSync } from 'node:fs'
import { readdir, readFile } from 'node:fs/promises'
import { dirname, join } from 'node:path'
import { FurrowError } from 'furrow'
import { cannotRead, cannotWrite } from './errors.ts'
import { uninterrupted } from './interruption.ts'
import { fileProblem, isStdout, statOf, targetOf } from './outputs.ts'

/** A file to write: its whole content, still in memory. */
export interface OutputFile {
  path: string
  bytes: Uint8Array
}

/** What the shell has opened, as in `furrow inspect <(...)`. Other pipes may have no writer, and devices no end. */
const OPEN_FILE = /^\/(dev\/stdin|(dev|proc\/self)\/fd\/\d+)$/

/**
 * Reads a file, or the pipe that a shell has opened.
 *
 * @param noun what the file is to the user, e.g. `the face`; put before its path in the error.
 * @throws FurrowError when it cannot be read.
 */
export async function readBytes(path: string, who: string, noun = '', remedy?: string): Promise<Buffer> {
  const name = `${noun} ${path}`.trim()
  const problem = OPEN_FILE.test(path) ? undefined : fileProblem(await statOf(path).catch(() => undefined))
  if (problem) throw cannotRead(who, name, new Error(problem), { remedy: 'name a file' })
  try {
    return await readFile(path)
  } catch (error) {
    throw cannotRead(who, name, error, remedy === undefined ? {} : { remedy })
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
 * Writes all files or none: everything goes to temporary files beside their targets first, which are then renamed.
 * Creates missing folders. No signal interrupts it. What is for stdout follows when all else is written.
 *
 * @throws FurrowError naming the file that cannot be written.
 */
export async function writeAll(outputs: readonly OutputFile[], who: string): Promise<void> {
  const files: (OutputFile & { target: string })[] = []
  for (const output of outputs) {
    if (!isStdout(output.path)) files.push({ ...output, target: await targetOf(output.path) })
  }
  await uninterrupted(() => writeFiles(files, who))
  for (const { path, bytes } of outputs) if (isStdout(path)) await writeStdout(bytes, who)
}

function writeFiles(files: readonly (OutputFile & { target: string })[], who: string): void {
  const undo: (() => void)[] = []
  let current = ''
  try {
    const renames = files.map(({ path, bytes, target }) => {
      current = path
      makeFolder(dirname(target), undo)
      const temporary = temporaryPath(target)
      undo.push(() => rmSync(temporary, { force: true }))
      writeFileSync(temporary, bytes)
      return { path, temporary, target }
    })
    for (const { path, temporary, target } of renames) {
      current = path
      renameSync(temporary, target)
    }
  } catch (error) {
    for (const step of undo.reverse()) step()
    throw cannotWrite(who, current, error)
  }
}

/** Writes a new folder whole or not at all: it is filled under a temporary name beside it, then renamed. */
export async function writeFolder(
  folder: string,
  outputs: readonly OutputFile[],
  who: string,
): Promise<void> {
  const target = await targetOf(folder)
  await uninterrupted(() => {
    const undo: (() => void)[] = []
    try {
      makeFolder(dirname(target), undo)
      const temporary = temporaryPath(target)
      undo.push(() => rmSync(temporary, { recursive: true, force: true }))
      const files = outputs.map(({ path, bytes }) => ({
        path: join(folder, path),
        bytes,
        target: join(temporary, path),
      }))
      writeFiles(files, who)
      // Only an empty folder is removed; otherwise the rename fails and nothing of the user's is lost.
      if (existsSync(target)) rmdirSync(target)
      renameSync(temporary, target)
    } catch (error) {
      for (const step of undo.reverse()) step()
      throw error instanceof FurrowError ? error : cannotWrite(who, folder, error)
    }
  })
}

/** Makes a folder and those above it; what was made is removed by `undo`. */
function makeFolder(folder: string, undo: (() => void)[]): void {
  const first = mkdirSync(folder, { recursive: true })
  if (first === undefined) return
  undo.push(() => {
    for (let made = folder; made.length >= first.length; made = dirname(made)) rmdirSync(made)
  })
}

function writeStdout(bytes: Uint8Array, who: string): Promise<void> {
  return new Promise((resolve, reject) => {
    process.stdout.write(bytes, (error) => (error ? reject(cannotWrite(who, 'to stdout', error)) : resolve()))
  })
}

/** Throws FurrowError where a path that is to become a folder is a file. */
export async function checkFolder(path: string, who: string): Promise<void> {
  const found = await folderAt(path, who)
  if (!found || found.isDirectory()) return
  throw new FurrowError({ code: 'unwritable', who, what: `${path} is not a folder`, remedy: 'name a folder' })
}

/** Throws FurrowError where a path is a file or a folder with contents. */
export async function checkNewFolder(path: string, who: string): Promise<void> {
  const found = await folderAt(path, who)
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

function folderAt(path: string, who: string): Promise<Stats | undefined> {
  return statOf(path).catch((error) => {
    throw cannotWrite(who, path, error)
  })
}

let temporaries = 0

/** Short, since the name of the file itself may be as long as names can be. */
function temporaryPath(target: string): string {
  return join(dirname(target), `.furrow-${process.pid}-${++temporaries}.tmp`)
}
