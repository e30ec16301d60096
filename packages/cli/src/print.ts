import { isStdout } from './outputs.ts'

/** Control characters and bidirectional characters. Names with these characters could forge or hide output. */
const UNSAFE = /[\p{Cc}\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]/gu

/** Escapes unsafe characters as `\uXXXX`. If the text is JSON, its value does not change. */
export function escaped(text: string): string {
  return text.replace(UNSAFE, (found) => `\\u${found.charCodeAt(0).toString(16).padStart(4, '0')}`)
}

export interface Printed {
  lines: string[]
  warnings: string[]
}

let captured: Printed | undefined

/** Runs a command, and collects its output in `printed` without printing it. Only one command can run at a time. */
export async function capturePrinted(printed: Printed, command: () => Promise<unknown>): Promise<void> {
  captured = printed
  try {
    await command()
  } finally {
    captured = undefined
  }
}

/**
 * Prints the result of a command to stdout. If one of `files` is stdout, prints to stderr.
 *
 * @param lines lines of the result. Line breaks in a line are escaped.
 * @param files paths of the files that the command has written.
 */
export function print(lines: string | readonly string[], ...files: readonly (string | undefined)[]): void {
  if (captured) return void captured.lines.push(...[lines].flat())
  const stream = files.some((file) => file !== undefined && isStdout(file)) ? process.stderr : process.stdout
  for (const line of [lines].flat()) stream.write(`${escaped(line)}\n`)
}

export function warn(text: string): void {
  if (captured) return void captured.warnings.push(text)
  console.error(escaped(text))
}
