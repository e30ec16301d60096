import { isStdout } from './outputs.ts'

/** Control characters, and those that change the direction of text: in names they could forge or hide output. */
const UNSAFE = /[\p{Cc}\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]/gu

/** Makes what comes from a file safe to print; what is valid JSON remains the same JSON. */
export function escaped(text: string): string {
  return text.replace(UNSAFE, (found) => `\\u${found.charCodeAt(0).toString(16).padStart(4, '0')}`)
}

/** What a command printed: lines of its result, and its warnings. */
export interface Printed {
  lines: string[]
  warnings: string[]
}

let gathered: Printed | undefined

/** Runs a command whose lines and warnings are put into `printed` instead of being printed. One at a time. */
export async function gatherPrinted(printed: Printed, command: () => Promise<unknown>): Promise<void> {
  gathered = printed
  try {
    await command()
  } finally {
    gathered = undefined
  }
}

/**
 * Prints the result of a command on stdout, or on stderr where one of its files is written to stdout.
 *
 * @param lines each becomes one line, whatever is in it.
 */
export function print(lines: string | readonly string[], ...files: readonly (string | undefined)[]): void {
  if (gathered) return void gathered.lines.push(...[lines].flat())
  const stream = files.some((file) => file !== undefined && isStdout(file)) ? process.stderr : process.stdout
  for (const line of [lines].flat()) stream.write(`${escaped(line)}\n`)
}

/** Prints a warning or an error in one line on stderr. */
export function warn(text: string): void {
  if (gathered) return void gathered.warnings.push(text)
  console.error(escaped(text))
}
