/** What each figure is to stay below, by how its name begins: milliseconds until the frame, on a software rasteriser. */
const GOALS = {
  'drop to face': 1000,
  'first stroke to relief': 100,
  'stroke to relief': 100,
  'longest task': 50,
  'furrow/auto: low': 1000,
  'furrow/auto: scan': 4000,
}

/**
 * Results as Markdown.
 *
 * @param results medians of each figure, by the name of the build.
 */
export function toTable(results, builds) {
  const head = ['figure', ...builds.flatMap((build) => [build, 'drawn']), 'goal']
  const rows = results.map(({ figure, medians }) => [
    figure,
    ...builds.flatMap((build) => [text(medians[build]?.submitted), text(medians[build]?.seen)]),
    GOALS[Object.keys(GOALS).find((start) => figure.startsWith(start))] ?? '',
  ])
  return `${[head, head.map(() => '---'), ...rows].map((row) => `| ${row.join(' | ')} |`).join('\n')}\n`
}

function text(value) {
  if (value === undefined) return ''
  return value < 10 ? value.toFixed(1) : Math.round(value).toLocaleString('en')
}
