/** Goals in milliseconds, by the beginning of the figure's name. They hold for a software rasteriser. */
const GOALS: Record<string, number> = {
  'drop to face': 1000,
  'first stroke to heights': 100,
  'stroke to heights': 100,
  'longest task': 50,
  'furrow/auto: low': 1000,
  'furrow/auto: scan': 4000,
}

/** A measured figure. */
export interface Result {
  figure: string
  /**
   * Medians by build. For response times, `submitted` is the time until a frame was submitted, and `seen` the time until its pixels could be read,
   * in milliseconds. Other figures have only `submitted`.
   */
  medians: Record<string, { submitted: number; seen?: number }>
}

/** Formats results as a Markdown table. */
export function toTable(results: readonly Result[], builds: readonly string[]): string {
  const head = ['figure', ...builds.flatMap((build) => [build, 'drawn']), 'goal']
  const rows = results.map(({ figure, medians }) => [
    figure,
    ...builds.flatMap((build) => [text(medians[build]?.submitted), text(medians[build]?.seen)]),
    goalOf(figure),
  ])
  return `${[head, head.map(() => '---'), ...rows].map((row) => `| ${row.join(' | ')} |`).join('\n')}\n`
}

function goalOf(figure: string): number | string {
  return Object.entries(GOALS).find(([start]) => figure.startsWith(start))?.[1] ?? ''
}

function text(value: number | undefined): string {
  if (value === undefined) return ''
  return value < 10 ? value.toFixed(1) : Math.round(value).toLocaleString('en')
}
