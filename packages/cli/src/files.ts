import { randomUUID } from 'node:crypto'
import {
  closeSync,
  existsSync,
  mkdirSync,
  openSync,
  renameSync,
  rmdirSync,
  rmSync,
  writeFileSync,
} from 'node:fs'
import { dirname, join } from 'node:path'
import { FurrowError } from 'furrow'
import { cannotWrite, type OutputFile } from 'furrow-files'
import { uninterrupted } from './interruption.ts'
import { checkReplaced, isStdout, type ReplaceRules, targetOf } from './outputs.ts'

/**
 * Writes files and creates missing folders. First writes all temporary files beside the targets, and then renames them.
 * So if a temporary file cannot be written, all targets stay unchanged. If a rename fails, earlier renames are not
 * undone. Signals do not interrupt this function. Writes to stdout last.
 *
 * @param rules exceptions from the rule that no output may overwrite a file that the command has read.
 * @throws FurrowError if a file cannot be written, or would overwrite an input.
 */
export async function writeAll(
  outputs: readonly OutputFile[],
  who: string,
  rules: ReplaceRules = {},
): Promise<void> {
  checkReplaced(
    outputs.map(({ path }) => path),
    who,
    rules,
  )
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
      // `wx` neither follows links nor replaces existing files.
      const file = openSync(temporary, 'wx')
      undo.push(() => rmSync(temporary, { force: true }))
      try {
        writeFileSync(file, bytes)
      } finally {
        closeSync(file)
      }
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

/**
 * Writes a new folder atomically. First it fills a temporary folder beside the target, and then it renames that folder.
 */
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
      // `rmdirSync` throws if the target is not empty, so no files are lost.
      if (existsSync(target)) rmdirSync(target)
      renameSync(temporary, target)
    } catch (error) {
      for (const step of undo.reverse()) step()
      throw error instanceof FurrowError ? error : cannotWrite(who, folder, error)
    }
  })
}

/** Creates a folder and its missing parents. Appends to `undo` a function that removes them. */
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

/**
 * Returns the path of a temporary file. Its name does not contain the name of the target, which may already have the
 * maximum length.
 */
function temporaryPath(target: string): string {
  return join(dirname(target), `.furrow-${randomUUID()}.tmp`)
}
