import { alikeness } from './alike.ts'
import type { MeasuredLine } from './measured.ts'
import type { SkinCharts } from './skin-charts.ts'

type Uv = MeasuredLine['uvs'][number]

/** Texture coordinate u of the middle of the face. The person's left is at larger u. */
const MIDDLE = 0.5

/** Compares the lines of a region in two patterns. Returns `alikeness`. */
export function compareRegion(
  charts: SkinCharts,
  region: string,
  lines: readonly MeasuredLine[],
  others: readonly MeasuredLine[],
): number | undefined {
  const [points, otherPoints] = [pointsOf(region, lines), pointsOf(region, others)]
  // The layout is skewed in opposite directions on the left and on the right, so each side has its own chart.
  const sides = [points.filter(isLeft), points.filter((uv) => !isLeft(uv))]
  return alikeness(
    sides.map((side) => {
      const chart = charts.chartAt(side)
      return { lines: side.map(chart), others: otherPoints.map(chart) }
    }),
  )
}

/** Compares the lines on the left side of a region with the mirrored lines on the right side. Returns `alikeness`. */
export function compareSides(
  charts: SkinCharts,
  region: string,
  lines: readonly MeasuredLine[],
): number | undefined {
  const points = pointsOf(region, lines)
  const left = points.filter(isLeft)
  const right = points.filter((uv) => !isLeft(uv)).map(([u, v]) => [2 * MIDDLE - u, v] as const)
  const chart = charts.chartAt(left)
  return alikeness([{ lines: left.map(chart), others: right.map(chart) }])
}

function pointsOf(region: string, lines: readonly MeasuredLine[]): Uv[] {
  return lines.filter((line) => line.region === region).flatMap(({ uvs }) => uvs)
}

function isLeft([u]: Uv): boolean {
  return u > MIDDLE
}
