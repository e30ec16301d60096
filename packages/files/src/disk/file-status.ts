import type { Stats } from 'node:fs'
import { stat } from 'node:fs/promises'

/** Returns an error text if a path exists and is not a regular file, otherwise undefined. */
export function fileProblem(found: Pick<Stats, 'isFile' | 'isDirectory'> | undefined): string | undefined {
  if (!found || found.isFile()) return undefined
  return found.isDirectory() ? 'it is a folder' : 'it is a device, pipe or socket'
}

/** Reads the status of a path. Returns undefined if it does not exist. */
export async function statOf(path: string): Promise<Stats | undefined> {
  return stat(path).catch(ignoreMissing)
}

/** Handler for `Promise.catch`: ignores the error of a missing file and rethrows other errors. */
export function ignoreMissing(error: NodeJS.ErrnoException): undefined {
  if (error.code !== 'ENOENT' && error.code !== 'ENOTDIR') throw error
}
