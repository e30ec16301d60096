import { constants, type Stats } from 'node:fs'
import { access, lstat, readdir, readlink, realpath, stat } from 'node:fs/promises'
import { dirname, join, relative, resolve } from 'node:path'
import { FurrowError } from 'furrow'
import { cannotWrite } from 'furrow-files'
import { fileProblem, ignoreMissing, statOf, wasRead } from 'furrow-files/node'

/** What the files that a command writes may be. */
export interface OutputRules {
  /** What their names may end with; `.png` by default. */
  extensions?: readonly string[]
  /** The files that the command reads. */
  inputs?: readonly string[]
  /** Whether an output may replace an input; to be left out by commands without `--force`. */
  force?: boolean | undefined
}

/** Outputs that may replace a file that the command has read; none by default. */
export interface ReplaceRules {
  /** Outputs that the user named: they may with `force`. To be left out by commands without `--force`. */
  named?: readonly (string | undefined)[]
  force?: boolean | undefined
  /** Outputs that are there to be updated: they may always. */
  updated?: readonly string[]
}

/** Names of stdout. It is never opened by name: as root, renaming a file to it would replace the device. */
const STDOUT = ['-', '/dev/stdout', '/dev/fd/1', '/proc/self/fd/1']

/** More links than this in a row are a circle. */
const MOST_LINKS = 40

/** Whether an output is to be written to stdout. */
export function isStdout(path: string): boolean {
  return STDOUT.includes(path)
}

/**
 * Checks before any work is done that all files of a command can be written, that no two of them are the same, and
 * that none of them is an input. Symbolic and hard links are considered.
 *
 * @param paths those that are undefined were not asked for.
 * @throws FurrowError naming the file.
 */
export async function checkOutputs(
  paths: readonly (string | undefined)[],
  who: string,
  { extensions = ['.png'], inputs = [], force }: OutputRules = {},
): Promise<void> {
  const outputs = paths.filter((path) => path !== undefined)
  for (const path of outputs) await checkWritable(path, who, extensions)
  const written = await Promise.all(outputs.map(identityOf))
  const twice = outputs.find((_, i) => written.indexOf(written[i]) < i)
  if (twice !== undefined) {
    throw new FurrowError({
      code: 'usage',
      who,
      problem: 'one file for two outputs',
      value: twice,
      remedy: 'give each a file of its own',
    })
  }
  if (force) return
  // An input that cannot be looked at is an error of reading it.
  const read = await Promise.all(inputs.map((path) => identityOf(path).catch(() => path)))
  const over = outputs.find((_, i) => read.includes(written[i]))
  if (over !== undefined) throw overInput(over, who, force)
}

/**
 * Checks that no output replaces a file that the command has read, directly or by reference. All outputs pass this check just before they
 * are written.
 *
 * @throws FurrowError naming the first output that would.
 */
export function checkReplaced(
  paths: readonly string[],
  who: string,
  { named = [], force, updated = [] }: ReplaceRules = {},
): void {
  const over = paths.find((path) => {
    return !isStdout(path) && !updated.includes(path) && !(force && named.includes(path)) && wasRead(path)
  })
  if (over !== undefined) throw overInput(over, who, named.includes(over) ? force : undefined)
}

/** The error for an output that would replace an input; `force` as in `OutputRules`. */
function overInput(path: string, who: string, force: boolean | undefined): FurrowError {
  return new FurrowError({
    code: 'unwritable',
    who,
    problem: `${path} is the input`,
    remedy: `name another output${force === undefined ? '' : ', or replace it with --force'}`,
  })
}

/**
 * Checks that a file can be written. Leaves nothing behind.
 *
 * @param extensions what its name may end with, in any case.
 * @throws FurrowError when it cannot.
 */
async function checkWritable(path: string, who: string, extensions: readonly string[]): Promise<void> {
  if (isStdout(path)) {
    if (!process.stdout.isTTY) return
    throw cannotWrite(who, 'to stdout', new Error('it is the terminal'), 'write to a file or a pipe')
  }
  if (!extensions.some((extension) => path.toLowerCase().endsWith(extension))) {
    const problem = `its name does not end in ${extensions.join(' or ')}`
    throw cannotWrite(who, path, problem, `name it e.g. face${extensions[0]}`)
  }
  try {
    const target = await targetOf(path)
    const found = await statOf(target)
    const problem = fileProblem(found)
    if (problem) throw cannotWrite(who, path, problem, 'name a file; -o - writes to stdout')
    if (found) await access(target, constants.W_OK)
    await access(await nearestFolder(dirname(target)), constants.W_OK)
  } catch (error) {
    throw error instanceof FurrowError ? error : cannotWrite(who, path, error)
  }
}

/**
 * Checks that files can be written into a folder, which need not exist yet. Leaves nothing behind.
 *
 * @throws FurrowError when they cannot.
 */
export async function checkFolder(path: string, who: string): Promise<void> {
  const found = await folderAt(path, who)
  if (!found || found.isDirectory()) return
  throw cannotWrite(who, path, new Error('it is not a folder'), 'name a folder')
}

/** The same for a folder that is made as a whole: there may be an empty one, which is replaced. */
export async function checkNewFolder(path: string, who: string): Promise<void> {
  const found = await folderAt(path, who)
  if (!found) return
  if (!found.isDirectory() || (await readdir(path)).length > 0) {
    throw new FurrowError({
      code: 'unwritable',
      who,
      problem: `${path} is ${found.isDirectory() ? 'not empty' : 'a file'}`,
      limit: 'a new or an empty folder',
      remedy: 'name another one; nothing is overwritten',
    })
  }
  await checkFolder(dirname(await targetOf(path)), who)
}

/** What is at a path; throws FurrowError where it, or the folder that it would be in, cannot be written. */
async function folderAt(path: string, who: string): Promise<Stats | undefined> {
  if (isStdout(path)) {
    throw cannotWrite(who, 'a folder to stdout', new Error('it takes one file'), 'name a folder')
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

/** The file that is written for a path: links are followed, also those to files that do not exist yet. */
export async function targetOf(path: string): Promise<string> {
  let target = resolve(path)
  for (let links = 0; links < MOST_LINKS; links++) {
    const found = await lstat(target).catch(ignoreMissing)
    if (!found?.isSymbolicLink()) return target
    target = resolve(await realpath(dirname(target)), await readlink(target))
  }
  return realpath(path)
}

/** The same text for the same file, by whatever path. */
async function identityOf(path: string): Promise<string> {
  if (isStdout(path)) return 'stdout'
  const target = await targetOf(path)
  const found = await stat(target, { bigint: true }).catch(ignoreMissing)
  return found ? `${found.dev}:${found.ino}` : realPathOf(target)
}

/** The same path for the same file, of which neither it nor its folder need be there: links are followed. */
export async function realTarget(path: string): Promise<string> {
  return realPathOf(await targetOf(path))
}

async function realPathOf(target: string): Promise<string> {
  const folder = await nearestFolder(dirname(target))
  return join(await realpath(folder), relative(folder, target))
}

/** The folder itself, or its nearest ancestor that exists. */
async function nearestFolder(path: string): Promise<string> {
  const found = await statOf(path)
  if (found?.isDirectory()) return path
  if (found) throw new Error(`${shortest(path)} is not a folder`)
  const parent = dirname(path)
  if (parent === path) throw new Error(`${path} does not exist`)
  return nearestFolder(parent)
}

/** A path as the user would write it. */
function shortest(path: string): string {
  const way = relative(process.cwd(), path)
  return way.length < path.length ? way : path
}
