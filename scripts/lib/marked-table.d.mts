export function readTable(page: string, name: string): string[]
export function writeTable(page: string, name: string, lines: readonly string[]): void
