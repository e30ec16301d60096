/** Reads the lines of a generated table between the comments `NAME` and `end of NAME`. The page is relative to the repository's root. */
export function readTable(page: string, name: string): string[]
/** Replaces the lines of a generated table. */
export function writeTable(page: string, name: string, lines: readonly string[]): void
