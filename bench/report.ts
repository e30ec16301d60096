import type { Case, RendererKind } from './case.ts'
import type { Drawer } from './draw.ts'
import { median, ratio, spread } from './statistics.ts'

/** What a page measured of one variant in one case. */
export interface Measured {
  variant: string
  /** Milliseconds a frame took, a median for each round. */
  rounds: number[]
  /** Share of the picture's pixels that differ from the plain face, 0..1. */
  changed: number
}

/** Where it was measured. */
export interface Setting {
  width: number
  height: number
  renderer: RendererKind
  adapter: string
  /** Whose clock told the times. */
  timing: Drawer['timing']
}

/** One entry of the JSON. */
export interface Result extends Case, Setting {
  variant: string
  medianMs: number
  /** Distance between the quartiles of the rounds. */
  spreadMs: number
  ratioToPlain: number
  /** Null where the paper's shader cannot show the case. */
  ratioToPaper: number | null
}

/** @throws Error when the plain face is missing, to which all others are compared. */
export function toResults(shown: Case, setting: Setting, measured: readonly Measured[]): Result[] {
  const plain = measured.find(({ variant }) => variant === 'plain')
  const paper = measured.find(({ variant }) => variant === 'paper')
  if (!plain) throw new Error('bench: the variant "plain" was not measured; all others are compared to it')
  return measured.map(({ variant, rounds }) => ({
    variant,
    ...shown,
    ...setting,
    medianMs: median(rounds),
    spreadMs: spread(rounds),
    ratioToPlain: ratio(rounds, plain.rounds),
    ratioToPaper: paper ? ratio(rounds, paper.rounds) : null,
  }))
}

const COLUMNS = [
  'renderer',
  'layers',
  'areas',
  'active',
  'moving',
  'variant',
  'ms',
  '±',
  '/ plain',
  '/ paper',
]

/** The results as a Markdown table. */
export function toTable(results: readonly Result[]): string {
  const rows = results.map((result) => [
    result.renderer,
    `${result.layers}`,
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
