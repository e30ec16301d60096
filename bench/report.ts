import type { RendererKind } from '../stage/stage.ts'
import type { Case } from './case.ts'
import type { TimedRenderer } from './page/timed-renderer.ts'
import { median, ratio, spread } from './statistics.ts'

/** Measurements of one variant in one case. */
export interface Measured {
  variant: string
  /** Mean milliseconds per frame by round. Each round compiles the variant. */
  rounds: number[]
  /** Fraction of pixels that differ from the plain face, 0..1. */
  changed: number
}

/** Picture size, renderer and GPU of a measurement. */
export interface Setup {
  width: number
  height: number
  renderer: RendererKind
  adapter: string
  timing: TimedRenderer['timing']
}

/** One entry of the JSON output. */
export interface Result extends Case, Setup {
  variant: string
  medianMs: number
  /** Interquartile range of the rounds. */
  spreadMs: number
  ratioToPlain: number
  /** Null if the paper's shader does not support the case. */
  ratioToPaper: number | null
}

/** Computes results relative to the plain face. Throws if it was not measured. */
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

/** Formats results as a Markdown table. */
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
