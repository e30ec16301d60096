import { REVISION } from 'three'
import { version } from '../packages/furrow/package.json'
import type { RendererKind } from '../stage/stage.ts'
import { RENDERER_KINDS } from './case.ts'
import type { Result } from './report.ts'

export interface Machine {
  /** Name and version of the browser, or of Dawn in Node, and the operating system. */
  browser: string
  date: Date
}

/** Columns with frame times relative to the plain face, which has no wrinkles. */
const RATIOS: readonly { title: string; variant: string; maps: Result['maps'] }[] = [
  ...['furrow', 'stripped', 'jimenez', 'o3de'].map(
    (variant) => ({ title: variant, variant, maps: 'normals' }) as const,
  ),
  ...['furrow', 'stripped'].map(
    (variant) => ({ title: `all maps: ${variant}`, variant, maps: 'all' }) as const,
  ),
]

export const LINE_VARIANTS: readonly string[] = ['plain', ...new Set(RATIOS.map(({ variant }) => variant))]

const TITLES = [
  'date',
  'adapter',
  'browser',
  'picture',
  'timed by',
  'plain, ms',
  ...RATIOS.map(({ title }) => title),
  'versions',
]

/** Markdown heading of the table whose rows `toLine` returns. */
export const LINE_HEADING: string = [TITLES, TITLES.map(() => '---')].map(toRow).join('\n')

/**
 * Formats a benchmark run as a row of the table in bench/machines.md. The row lists the cases with 8 areas and one layer. A semicolon separates
 * WebGL from WebGPU, and a comma separates moving from still wrinkles. A dash means that the case was not measured.
 */
export function toLine(results: readonly Result[], { browser, date }: Machine): string {
  const shown = results.filter(({ areas, active, layers }) => areas === 8 && active === 8 && layers === 1)
  const [{ width, height }] = shown
  const find = (renderer: RendererKind, variant: string, maps: Result['maps'], still: boolean) =>
    shown.find(
      (result) =>
        result.renderer === renderer &&
        result.variant === variant &&
        result.maps === maps &&
        result.still === still,
    )
  const distinct = (name: 'adapter' | 'timing') =>
    [...new Set(shown.map((result) => result[name]))].join('; ')
  const joinRenderers = (value: (renderer: RendererKind) => string) => RENDERER_KINDS.map(value).join('; ')
  return toRow([
    date.toISOString().slice(0, 10),
    distinct('adapter'),
    browser,
    `${width} x ${height}`,
    distinct('timing'),
    joinRenderers((renderer) => find(renderer, 'plain', 'normals', false)?.medianMs.toFixed(2) ?? '-'),
    ...RATIOS.map(({ variant, maps }) =>
      joinRenderers((renderer) =>
        [false, true]
          .map((still) => find(renderer, variant, maps, still)?.ratioToPlain.toFixed(3) ?? '-')
          .join(', '),
      ),
    ),
    `furrow ${version}, three.js r${REVISION}`,
  ])
}

function toRow(cells: readonly string[]): string {
  return `| ${cells.map((cell) => cell.replaceAll(/\s+/g, ' ').replaceAll('|', '\\|')).join(' | ')} |`
}
