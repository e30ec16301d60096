import { type BigIntStats, statSync } from 'node:fs'

/** Identity of each file that the running command has read. */
const filesRead = new Set<string>()

/** Returns the device and inode of a file, which are equal for all paths and links to the same file. */
const identityOf = ({ dev, ino }: BigIntStats) => `${dev}:${ino}`

/** Records that the running command reads a file. Outputs must not overwrite recorded files, see `wasRead`. */
export function recordRead(stats: BigIntStats): void {
  filesRead.add(identityOf(stats))
}

/** Forgets all recorded files. Called before each command. */
export function forgetFilesRead(): void {
  filesRead.clear()
}

/** Returns whether the running command has read the file at a path, possibly by another path or link. */
export function wasRead(path: string): boolean {
  try {
    return filesRead.has(identityOf(statSync(path, { bigint: true })))
  } catch {
    // The file is missing or inaccessible, so the command has not read it.
    return false
  }
}
