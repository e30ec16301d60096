import type { Stats } from 'node:fs'
import { stat } from 'node:fs/promises'

/** Why what is at a path can be neither read nor replaced; undefined where it can. */
export function fileProblem(found: Pick<Stats, 'isFile' | 'isDirectory'> | undefined): string | undefined {
  if (!found || found.isFile()) return undefined
  return found.isDirectory() ? 'it is a folder' : 'it is a device, pipe or socket'
}

/** Reads the status of a path; undefined where there is nothing. */
export async function statOf(path: string): Promise<Stats | undefined> {
  return stat(path).catch(ignoreMissing)
}

/** For `catch`: nothing where there is no such file; other errors are thrown. */
export function ignoreMissing(error: NodeJS.ErrnoException): undefined {
  if (error.code !== 'ENOENT' && error.code !== 'ENOTDIR') throw error
}
