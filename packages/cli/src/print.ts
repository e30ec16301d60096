import { isStdout } from './outputs.ts'

/** Control and bidirectional characters: names with them could forge or hide output. */
const UNSAFE = /[\p{Cc}\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]/gu

/** Escapes unsafe characters. JSON text keeps its value. */
export function escaped(text: string): string {
  return text.replace(UNSAFE, (found) => `\\u${found.charCodeAt(0).toString(16).padStart(4, '0')}`)
}

/** Output of a command: result lines and warnings. */
export interface Printed {
  lines: string[]
  warnings: string[]
}

let captured: Printed | undefined

/** Runs a command and collects its output in `printed` instead of printing it. One command at a time. */
export async function capturePrinted(printed: Printed, command: () => Promise<unknown>): Promise<void> {
  captured = printed
  try {
    await command()
  } finally {
    captured = undefined
  }
}

/**
 * Prints the result of a command to stdout, or to stderr if one of its files is written to stdout.
 *
 * @param lines result lines; line breaks in them are escaped.
 */
export function print(lines: string | readonly string[], ...files: readonly (string | undefined)[]): void {
  if (captured) return void captured.lines.push(...[lines].flat())
  const stream = files.some((file) => file !== undefined && isStdout(file)) ? process.stderr : process.stdout
  for (const line of [lines].flat()) stream.write(`${escaped(line)}\n`)
}

/** Prints a warning or an error to stderr, as one line. */
export function warn(text: string): void {
  if (captured) return void captured.warnings.push(text)
  console.error(escaped(text))
}
