import { kilobytes } from 'furrow-files'
import type { ResultLine } from '../results.ts'

/** Rows that a page shows at most: a phone scrolls through these. Failures and warnings come first. */
export const MOST_ROWS = 2000

/** A cell of a table: what it shows, and what it is sorted by. */
export interface Cell {
  text: string
  value: number | string
}

/** The lines that a page shows, those that need a look first. */
export function rowsOf(lines: readonly ResultLine[]): ResultLine[] {
  const order = (line: ResultLine) => (line.status === 'failed' ? 0 : line.warnings.length > 0 ? 1 : 2)
  return [...lines].sort((a, b) => order(a) - order(b) || (a.input < b.input ? -1 : 1)).slice(0, MOST_ROWS)
}

export function sizeCell({ bytes }: ResultLine): Cell {
  return { text: bytes === undefined ? '' : kilobytes(bytes), value: bytes ?? -1 }
}

export function timeCell({ seconds, sameAs }: ResultLine): Cell {
  return sameAs === undefined
    ? { text: `${seconds.toFixed(1)} s`, value: seconds }
    : { text: 'shared', value: 0 }
}

/** What the command found, as far as it is numbers. */
export function foundText({ result = {} }: ResultLine): string {
  const names = ['layers', 'areas', 'errors', 'warnings'] as const
  const known = names.filter((name) => typeof result[name] === 'number')
  return known.map((name) => `${result[name]} ${name}`).join(', ')
}
