import type { RendererKind } from '../stage/stage.ts'
import type { Case } from './case.ts'
import type { TimedRenderer } from './page/timed-renderer.ts'
import { median, ratio, spread } from './statistics.ts'

/** Measurements of one variant in one case. */
export interface Measured {
  variant: string
  /** Milliseconds per frame, one number per round. */
  rounds: number[]
  /** Fraction of pixels that differ from the face without wrinkles, 0..1. */
  changed: number
}

export interface Setup {
  width: number
  height: number
  renderer: RendererKind
  adapter: string
  timing: TimedRenderer['timing']
}

/** One entry of the benchmark's JSON output. */
export interface Result extends Case, Setup {
  variant: string
  medianMs: number
  /** Interquartile range of the rounds, milliseconds. */
  spreadMs: number
  /** Frame time divided by that of `plain`, the face without wrinkles. */
  ratioToPlain: number
  /** Frame time divided by that of `paper`. Null if `paper` does not support the case. */
  ratioToPaper: number | null
}

/** Computes the results of a case. Throws if the variant `plain` was not measured. */
export function toResults(benchCase: Case, setup: Setup, measured: readonly Measured[]): Result[] {
  const plain = measured.find(({ variant }) => variant === 'plain')
  const paper = measured.find(({ variant }) => variant === 'paper')
  if (!plain) throw new Error('bench: the variant "plain" was not measured; all others are compared with it')
  return measured.map(({ variant, rounds }) => ({
    variant,
    ...benchCase,
    ...setup,
    medianMs: median(rounds),
    spreadMs: spread(rounds),
    ratioToPlain: ratio(rounds, plain.rounds),
    ratioToPaper: paper ? ratio(rounds, paper.rounds) : null,
  }))
}

const COLUMNS = [
  'renderer',
  'layers',
  'maps',
  'areas',
  'active',
  'moving',
  'variant',
  'ms',
  '±',
  '/ plain',
  '/ paper',
]

export function toTable(results: readonly Result[]): string {
  const rows = results.map((result) => [
    result.renderer,
    `${result.layers}`,
    result.maps,
    `${result.areas}`,
    `${result.active}`,
    result.still ? 'no' : 'yes',
    result.variant,
    result.medianMs.toFixed(2),
    result.spreadMs.toFixed(2),
    result.ratioToPlain.toFixed(3),
    result.ratioToPaper?.toFixed(3) ?? '',
  ])
  const widths = COLUMNS.map((name, i) => Math.max(name.length, ...rows.map((row) => row[i].length)))
  const line = (cells: string[]) => `| ${cells.map((cell, i) => cell.padEnd(widths[i])).join(' | ')} |`
  return [line(COLUMNS), line(widths.map((width) => '-'.repeat(width))), ...rows.map(line)].join('\n')
}
