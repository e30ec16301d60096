import type { Stats } from 'node:fs'
import { stat } from 'node:fs/promises'

/** Returns the problem if a path is not a regular file or missing, otherwise undefined. */
export function fileProblem(found: Pick<Stats, 'isFile' | 'isDirectory'> | undefined): string | undefined {
  if (!found || found.isFile()) return undefined
  return found.isDirectory() ? 'it is a folder' : 'it is a device, pipe or socket'
}

/** Reads the status of a path. Returns undefined if it does not exist. */
export async function statOf(path: string): Promise<Stats | undefined> {
  return stat(path).catch(ignoreMissing)
}

/** Error handler for `catch` that ignores missing files and rethrows other errors. */
export function ignoreMissing(error: NodeJS.ErrnoException): undefined {
  if (error.code !== 'ENOENT' && error.code !== 'ENOTDIR') throw error
}
