import type { Result } from './report.ts'

const SIZE = { width: 720, height: 400 }
const MARGIN = { left: 56, right: 120, top: 44, bottom: 48 }
/** Height of a line of text. */
const LINE = 13
/** Distinct to colour-blind readers too (Okabe and Ito's palette). */
const COLOURS: Record<string, string> = {
  plain: '#999999',
  furrow: '#0072b2',
  auto: '#cc79a7',
  composed: '#56b4e9',
  jimenez: '#009e73',
  o3de: '#e69f00',
  paper: '#d55e00',
}

/**
 * Plots frame times over the number of areas, as multiples of the plain face's, as SVG with logarithmic axes.
 *
 * @param results of one renderer; only those with one layer and all areas moving are plotted.
 */
export function toPlot(results: readonly Result[]): string {
  const shown = results.filter(
    ({ layers, maps, still, areas, active }) =>
      layers === 1 && maps === 'normals' && !still && areas === active,
  )
  const counts = [...new Set(shown.map(({ areas }) => areas))].sort((a, b) => a - b)
  const highest = Math.max(1.2, ...shown.map(({ ratioToPlain }) => ratioToPlain)) * 1.05
  const x = axis(counts[0], counts[counts.length - 1], MARGIN.left, SIZE.width - MARGIN.right)
  const y = axis(0.9, highest, SIZE.height - MARGIN.bottom, MARGIN.top)
  const lines = [1, 1.2, 1.5, 2, 3, 5, 10, 20].filter((value) => value <= highest)
  const [{ renderer, adapter, width, height }] = shown
  const title = `Frame time over that of the plain face, ${renderer}, ${width} x ${height}`
  const curves = Object.keys(COLOURS).flatMap((variant) => curveOf(variant, shown, x, y))
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${SIZE.width} ${SIZE.height}" font-family="sans-serif" font-size="12">`,
    `<title>${title}</title>`,
    `<rect width="100%" height="100%" fill="#ffffff"/>`,
    text(MARGIN.left, 18, title, 'font-weight="bold"'),
    text(MARGIN.left, 33, escapeXml(adapter), 'fill="#666666" font-size="10"'),
    ...lines.map((value) => grid(y(value), value)),
    ...counts.map((count) =>
      text(x(count), SIZE.height - MARGIN.bottom + 18, `${count}`, 'text-anchor="middle"'),
    ),
    text(
      (MARGIN.left + SIZE.width - MARGIN.right) / 2,
      SIZE.height - 12,
      'areas, all moving',
      'text-anchor="middle"',
    ),
    ...curves.map(draw),
    ...labels(curves),
    '</svg>',
    '',
  ].join('\n')
}

function axis(min: number, max: number, from: number, to: number): (value: number) => number {
  const span = Math.log(max / min) || 1
  return (value) => from + ((to - from) * Math.log(value / min)) / span
}

function grid(y: number, value: number): string {
  const [from, to] = [MARGIN.left, SIZE.width - MARGIN.right]
  const line = `<line x1="${from}" x2="${to}" y1="${y.toFixed(1)}" y2="${y.toFixed(1)}" stroke="#e5e5e5"/>`
  return line + text(from - 8, y + 4, `${value}`, 'text-anchor="end"')
}

interface Curve {
  variant: string
  points: [x: number, y: number][]
}

/** The curve of a variant; empty if it has no results. */
function curveOf(
  variant: string,
  results: readonly Result[],
  x: (value: number) => number,
  y: (value: number) => number,
): Curve[] {
  const points = results
    .filter((result) => result.variant === variant)
    .sort((a, b) => a.areas - b.areas)
    .map(({ areas, ratioToPlain }): [number, number] => [x(areas), y(ratioToPlain)])
  return points.length > 0 ? [{ variant, points }] : []
}

function draw({ variant, points }: Curve): string {
  const colour = COLOURS[variant]
  const rounded = points.map((point) => point.map((value) => value.toFixed(1)))
  return [
    `<polyline fill="none" stroke="${colour}" stroke-width="2" points="${rounded.map((point) => point.join()).join(' ')}"/>`,
    ...rounded.map(([cx, cy]) => `<circle cx="${cx}" cy="${cy}" r="3" fill="${colour}"/>`),
  ].join('')
}

/** Labels at the ends of the curves, stacked where ends are close. */
function labels(curves: readonly Curve[]): string[] {
  const ends = curves.map(({ variant, points }) => ({ variant, end: points[points.length - 1] }))
  const lowestFree = new Map<number, number>()
  return ends
    .sort((a, b) => b.end[1] - a.end[1])
    .map(({ variant, end: [x, y] }) => {
      const height = Math.min(y, lowestFree.get(x) ?? y)
      lowestFree.set(x, height - LINE)
      return text(x + 8, height + 4, variant, `fill="${COLOURS[variant]}"`)
    })
}

function text(x: number, y: number, words: string, attributes = ''): string {
  return `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" ${attributes}>${words}</text>`
}

function escapeXml(words: string): string {
  return words.replaceAll('&', '&amp;').replaceAll('<', '&lt;')
}
