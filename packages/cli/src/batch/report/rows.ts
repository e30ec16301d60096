import { kilobytes } from 'furrow-files'
import type { ResultLine } from '../results.ts'

/** Maximum number of rows in the report. A phone can still scroll this number of rows. */
export const MAX_ROWS = 2000

export interface Cell {
  text: string
  /** Sort key. */
  value: number | string
}

/** Returns the results that the report shows: failures first, then results with warnings, then the rest. */
export function rowsOf(lines: readonly ResultLine[]): ResultLine[] {
  const order = (line: ResultLine) => (line.status === 'failed' ? 0 : line.warnings.length > 0 ? 1 : 2)
  return [...lines].sort((a, b) => order(a) - order(b) || (a.input < b.input ? -1 : 1)).slice(0, MAX_ROWS)
}

export function sizeCell({ bytes }: ResultLine): Cell {
  return { text: bytes === undefined ? '' : kilobytes(bytes), value: bytes ?? -1 }
}

export function timeCell({ seconds, sameAs }: ResultLine): Cell {
  return sameAs === undefined
    ? { text: `${seconds.toFixed(1)} s`, value: seconds }
    : { text: 'shared', value: 0 }
}

/** Returns the counts in a result as text, e.g. `2 layers, 14 areas`. */
export function foundText({ result = {} }: ResultLine): string {
  const names = ['layers', 'areas', 'errors', 'warnings'] as const
  const known = names.filter((name) => typeof result[name] === 'number')
  return known.map((name) => `${result[name]} ${name}`).join(', ')
}
