import { constants, type Stats } from 'node:fs'
import { access, lstat, readdir, readlink, realpath, stat } from 'node:fs/promises'
import { dirname, join, relative, resolve } from 'node:path'
import { FurrowError } from 'furrow'
import { cannotWrite } from 'furrow-files'
import { fileProblem, ignoreMissing, statOf, wasRead } from 'furrow-files/node'

/** Rules for the output files of a command. */
export interface OutputRules {
  /** Allowed file extensions. Default `.png`. */
  extensions?: readonly string[]
  /** Paths of the files that the command reads. */
  inputs?: readonly string[]
  /** Whether an output may overwrite an input. Undefined for commands without `--force`. */
  force?: boolean | undefined
}

/** Outputs that may overwrite a file that the command has read. Default: none. */
export interface ReplaceRules {
  /** Outputs that the user has named. They may overwrite inputs if `force` is true. */
  named?: readonly (string | undefined)[]
  force?: boolean | undefined
  /** Outputs that may always overwrite inputs. */
  updated?: readonly string[]
}

/**
 * Names of stdout. These paths are never opened or replaced: if the user is root, renaming a file to such a path would
 * replace the device.
 */
const STDOUT = ['-', '/dev/stdout', '/dev/fd/1', '/proc/self/fd/1']

/** Maximum number of symbolic links that are followed. A longer chain is a cycle. */
const MAX_LINKS = 40

export function isStdout(path: string): boolean {
  return STDOUT.includes(path)
}

/**
 * Checks that all outputs can be written, differ from each other, and are not inputs. Resolves symbolic and hard links.
 * Call it before the command starts its work.
 *
 * @param paths paths of the outputs. Undefined entries are skipped.
 * @throws FurrowError for the first invalid output.
 */
export async function checkOutputs(
  paths: readonly (string | undefined)[],
  who: string,
  { extensions = ['.png'], inputs = [], force }: OutputRules = {},
): Promise<void> {
  const outputs = paths.filter((path) => path !== undefined)
  for (const path of outputs) await checkWritable(path, who, extensions)
  const written = await Promise.all(outputs.map(identityOf))
  const duplicate = outputs.find((_, i) => written.indexOf(written[i]) < i)
  if (duplicate !== undefined) {
    throw new FurrowError({
      code: 'usage',
      who,
      problem: 'two outputs are the same file',
      value: duplicate,
      remedy: 'choose different files',
    })
  }
  if (force) return
  // A missing input is reported when it is read.
  const read = await Promise.all(inputs.map((path) => identityOf(path).catch(() => path)))
  const overwriting = outputs.find((_, i) => read.includes(written[i]))
  if (overwriting !== undefined) throw overwritesInput(overwriting, who, force)
}

/**
 * Checks that no output overwrites a file that the command has read, directly or by reference. Call it just before the
 * outputs are written.
 *
 * @throws FurrowError for the first output that would overwrite an input.
 */
export function checkReplaced(
  paths: readonly string[],
  who: string,
  { named = [], force, updated = [] }: ReplaceRules = {},
): void {
  const overwriting = paths.find((path) => {
    return !isStdout(path) && !updated.includes(path) && !(force && named.includes(path)) && wasRead(path)
  })
  if (overwriting === undefined) return
  throw overwritesInput(overwriting, who, named.includes(overwriting) ? force : undefined)
}

/**
 * Creates the error for an output that would overwrite an input. `force` is undefined for commands without `--force`.
 */
function overwritesInput(path: string, who: string, force: boolean | undefined): FurrowError {
  return new FurrowError({
    code: 'unwritable',
    who,
    problem: `${path} is the input`,
    remedy: `choose another output${force === undefined ? '' : ', or overwrite it with --force'}`,
  })
}

/**
 * Checks that a file can be written. Does not write to it.
 *
 * @param extensions allowed file extensions, case-insensitive.
 * @throws FurrowError if the file cannot be written.
 */
async function checkWritable(path: string, who: string, extensions: readonly string[]): Promise<void> {
  if (isStdout(path)) {
    if (!process.stdout.isTTY) return
    throw cannotWrite(who, 'to stdout', new Error('it is the terminal'), 'write to a file or a pipe')
  }
  if (!extensions.some((extension) => path.toLowerCase().endsWith(extension))) {
    const problem = `the name does not end in ${extensions.join(' or ')}`
    throw cannotWrite(who, path, problem, `choose a name such as face${extensions[0]}`)
  }
  try {
    const target = await targetOf(path)
    const found = await statOf(target)
    const problem = fileProblem(found)
    if (problem) throw cannotWrite(who, path, problem, 'choose a file, or -o - for stdout')
    if (found) await access(target, constants.W_OK)
    await access(await nearestFolder(dirname(target)), constants.W_OK)
  } catch (error) {
    throw error instanceof FurrowError ? error : cannotWrite(who, path, error)
  }
}

/**
 * Checks that files can be written into a folder, which may not exist yet. Writes nothing.
 *
 * @throws FurrowError if files cannot be written.
 */
export async function checkFolder(path: string, who: string): Promise<void> {
  const found = await folderAt(path, who)
  if (!found || found.isDirectory()) return
  throw cannotWrite(who, path, new Error('it is not a folder'), 'choose a folder')
}

/** Throws unless a path is an empty folder, or does not exist and can be created. */
export async function checkNewFolder(path: string, who: string): Promise<void> {
  const found = await folderAt(path, who)
  if (!found) return
  if (!found.isDirectory() || (await readdir(path)).length > 0) {
    throw new FurrowError({
      code: 'unwritable',
      who,
      problem: `${path} is ${found.isDirectory() ? 'not empty' : 'a file'}`,
      limit: 'a new or empty folder',
      remedy: 'choose another folder',
    })
  }
  await checkFolder(dirname(await targetOf(path)), who)
}

/**
 * Returns the status of a path, if it exists. Throws if it is a folder without write permission, or if a folder could
 * not be created there.
 */
async function folderAt(path: string, who: string): Promise<Stats | undefined> {
  if (isStdout(path)) {
    throw cannotWrite(who, 'a folder to stdout', new Error('stdout takes one file'), 'choose a folder')
  }
  try {
    const target = await targetOf(path)
    const found = await statOf(target)
    if (!found || found.isDirectory()) await access(await nearestFolder(target), constants.W_OK)
    return found
  } catch (error) {
    throw cannotWrite(who, path, error)
  }
}

/** Resolves symbolic links in a path. The file that a link points to need not exist. */
export async function targetOf(path: string): Promise<string> {
  let target = resolve(path)
  for (let links = 0; links < MAX_LINKS; links++) {
    const found = await lstat(target).catch(ignoreMissing)
    if (!found?.isSymbolicLink()) return target
    target = resolve(await realpath(dirname(target)), await readlink(target))
  }
  return realpath(path)
}

/** Returns a key of a file. All paths to the same file have the same key. */
async function identityOf(path: string): Promise<string> {
  if (isStdout(path)) return 'stdout'
  const target = await targetOf(path)
  const found = await stat(target, { bigint: true }).catch(ignoreMissing)
  return found ? `${found.dev}:${found.ino}` : realPathOf(target)
}

/** Resolves all symbolic links in the path of a file. Neither the file nor its folder has to exist. */
export async function realTarget(path: string): Promise<string> {
  return realPathOf(await targetOf(path))
}

async function realPathOf(target: string): Promise<string> {
  const folder = await nearestFolder(dirname(target))
  return join(await realpath(folder), relative(folder, target))
}

async function nearestFolder(path: string): Promise<string> {
  const found = await statOf(path)
  if (found?.isDirectory()) return path
  if (found) throw new Error(`${displayPath(path)} is not a folder`)
  const parent = dirname(path)
  if (parent === path) throw new Error(`${path} does not exist`)
  return nearestFolder(parent)
}

/** Returns a path for messages: relative to the current folder if that is shorter. */
function displayPath(path: string): string {
  const relativePath = relative(process.cwd(), path)
  return relativePath.length < path.length ? relativePath : path
}
