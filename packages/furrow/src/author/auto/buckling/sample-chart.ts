import { rasterize } from '../../../math/rasterize.ts'
import { clamp, powerOfTwoFrom } from '../../../math/scalar.ts'
import { cornersOf, type SurfacePoint } from '../../skin/surface.ts'
import { bilinearForm, TENSOR_SIZE } from '../surface/tensors.ts'
import { type FlatChart, flatTriangle, liftPoint } from './flat-chart.ts'
import type { PeriodicGrid } from './grid-fft.ts'

/** Minimum number of samples per row and per column. */
const MIN_SAMPLES = 8

/** Grid over a flat chart, with a margin in which nothing is compressed. */
export interface ChartSamples {
  chart: FlatChart
  grid: PeriodicGrid
  /** Flat position of the first sample. */
  origin: readonly [x: number, y: number]
  /** Index of the chart's triangle at each sample; -1 outside the chart. */
  triangles: Int32Array
  /** Three barycentric coordinates per sample. */
  barycentrics: Float64Array
}

/**
 * Lays a grid over a chart. Halving or doubling the spacing does not change the extent of the grid.
 *
 * @param spacing distance between samples in millimetres.
 * @param margin minimum distance from the chart to its periodic copy, in millimetres.
 */
export function sampleChart(chart: FlatChart, spacing: number, margin: number): ChartSamples {
  const { flat } = chart
  const low = [Infinity, Infinity]
  const high = [-Infinity, -Infinity]
  for (let i = 0; i < flat.length; i++) {
    low[i % 2] = Math.min(low[i % 2], flat[i])
    high[i % 2] = Math.max(high[i % 2], flat[i])
  }
  const [width, height] = [0, 1].map((k) =>
    Math.max(MIN_SAMPLES, powerOfTwoFrom((high[k] - low[k] + margin) / spacing)),
  )
  const origin = [0, 1].map((k) => (low[k] + high[k] - spacing * (k === 0 ? width : height)) / 2)
  const triangles = new Int32Array(width * height).fill(-1)
  const barycentrics = new Float64Array(3 * width * height)
  const onGrid = new Float64Array(6)
  for (let index = 0; index < chart.triangles.length; index++) {
    const corners = flatTriangle(chart, index)
    for (let i = 0; i < 6; i++) onGrid[i] = (corners[i] - origin[i % 2]) / spacing
    rasterize(onGrid, 0, (column, row, a, b, c) => {
      const sample = row * width + column
      triangles[sample] = index
      barycentrics.set([a, b, c], 3 * sample)
    })
  }
  return { chart, grid: { width, height, spacing }, origin: [origin[0], origin[1]], triangles, barycentrics }
}

/** Returns the index of the sample nearest to a position. The position is relative to the first sample, in millimetres. */
export function sampleAt({ grid: { width, height, spacing } }: ChartSamples, x: number, y: number): number {
  const column = clamp(Math.round(x / spacing), 0, width - 1)
  const row = clamp(Math.round(y / spacing), 0, height - 1)
  return row * width + column
}

/**
 * Interpolates values of the chart's points at the samples; 0 outside the chart.
 *
 * @param values one value per point of the chart.
 */
export function sampleValues(
  { chart: { corners }, triangles, barycentrics }: ChartSamples,
  values: ArrayLike<number>,
): Float64Array {
  return Float64Array.from(triangles, (index, sample) => {
    if (index < 0) return 0
    let sum = 0
    for (let k = 0; k < 3; k++) sum += barycentrics[3 * sample + k] * values[corners[3 * index + k]]
    return sum
  })
}

/**
 * Samples a tensor field of the surface in the axes of the chart.
 *
 * @param tensors result of `compressionTensors` for the surface.
 * @param axes directions of the axes, see `chartAxes`.
 * @returns components xx, xy and yy; 0 outside the chart.
 */
export function sampleTensors(
  samples: ChartSamples,
  tensors: Float64Array,
  axes = chartAxes(samples.chart),
): [xx: Float64Array, xy: Float64Array, yy: Float64Array] {
  const { chart } = samples
  const parts = [0, 1, 2].map(() => new Float64Array(chart.points.length))
  for (const [i, point] of chart.points.entries()) {
    const tensor = tensors.subarray(TENSOR_SIZE * point, TENSOR_SIZE * (point + 1))
    const [x, y] = [axes.subarray(6 * i, 6 * i + 3), axes.subarray(6 * i + 3, 6 * i + 6)]
    parts[0][i] = bilinearForm(tensor, x, x)
    parts[1][i] = bilinearForm(tensor, x, y)
    parts[2][i] = bilinearForm(tensor, y, y)
  }
  return [sampleValues(samples, parts[0]), sampleValues(samples, parts[1]), sampleValues(samples, parts[2])]
}

/** Returns the directions that the chart's x and y axes have on the surface: two vectors per point, averaged over the point's triangles. */
export function chartAxes(chart: FlatChart): Float64Array {
  const { surface, triangles, corners, points } = chart
  const sums = new Float64Array(6 * points.length)
  const counts = new Float64Array(points.length)
  for (const [index, triangle] of triangles.entries()) {
    const flat = flatTriangle(chart, index)
    const [ux, uy, vx, vy] = [flat[2] - flat[0], flat[3] - flat[1], flat[4] - flat[0], flat[5] - flat[1]]
    const area = ux * vy - uy * vx
    if (area === 0) continue
    const [a, b, c] = cornersOf(surface, triangle)
    for (let k = 0; k < 3; k++) counts[corners[3 * index + k]]++
    for (let k = 0; k < 3; k++) {
      const u = surface.points[3 * b + k] - surface.points[3 * a + k]
      const v = surface.points[3 * c + k] - surface.points[3 * a + k]
      for (let corner = 0; corner < 3; corner++) {
        const first = 6 * corners[3 * index + corner] + k
        sums[first] += (vy * u - uy * v) / area
        sums[first + 3] += (ux * v - vx * u) / area
      }
    }
  }
  return sums.map((sum, i) => sum / (counts[Math.floor(i / 6)] || 1))
}

/**
 * Lifts the points of a line onto the surface.
 *
 * @param points packed x, y in millimetres from the first sample.
 * @returns one point of the surface per point of the line; undefined where the surface has a hole.
 */
export function liftLine(samples: ChartSamples, points: ArrayLike<number>): (SurfacePoint | undefined)[] {
  const { chart, origin, triangles } = samples
  let index = -1
  return Array.from({ length: points.length / 2 }, (_, i) => {
    const [x, y] = [points[2 * i], points[2 * i + 1]]
    if (index < 0) index = triangles[sampleAt(samples, x, y)]
    const found = index < 0 ? undefined : liftPoint(chart, index, origin[0] + x, origin[1] + y)
    index = found?.index ?? -1
    return found?.point
  })
}
