/** The lines of a table that a command writes. It stands between the comments `NAME` and `end of NAME`; the page is relative to the root. */
export function readTable(page: string, name: string): string[]
export function writeTable(page: string, name: string, lines: readonly string[]): void
