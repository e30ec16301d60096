import { type BigIntStats, statSync } from 'node:fs'

/** Identities of the files read by the running command. */
const filesRead = new Set<string>()

/** Device and inode: equal for all paths and links to a file. */
const identityOf = ({ dev, ino }: BigIntStats) => `${dev}:${ino}`

/** Records that the running command reads a file, so that no output overwrites it. */
export function recordRead(stats: BigIntStats): void {
  filesRead.add(identityOf(stats))
}

/** Clears the records; called before each command. */
export function forgetFilesRead(): void {
  filesRead.clear()
}

/** Returns whether the running command has read the file at a path, under any path or link. */
export function wasRead(path: string): boolean {
  try {
    return filesRead.has(identityOf(statSync(path, { bigint: true })))
  } catch {
    // A missing or inaccessible file was not read.
    return false
  }
}
