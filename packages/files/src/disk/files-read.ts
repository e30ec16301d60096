import { type BigIntStats, statSync } from 'node:fs'

/** Identities of the files that the running command has read. */
const filesRead = new Set<string>()

/** Device and inode: the same for the same file by any path or link. */
const identityOf = ({ dev, ino }: BigIntStats) => `${dev}:${ino}`

/** Records that the running command reads a file, so that none of its outputs replaces it. */
export function recordRead(stats: BigIntStats): void {
  filesRead.add(identityOf(stats))
}

/** Forgets the files of the command before. */
export function forgetFilesRead(): void {
  filesRead.clear()
}

/** Whether what is at a path now was read by the running command, by whatever path or link. */
export function wasRead(path: string): boolean {
  try {
    return filesRead.has(identityOf(statSync(path, { bigint: true })))
  } catch {
    // A missing or inaccessible file was not read.
    return false
  }
}
