import { length2 } from '../../../math/vector.ts'
import type { SkinSurface, SurfacePoint } from '../../skin/surface.ts'
import type { BucklingRegion, LineStyle, SkinFilm } from '../anatomy/region.ts'
import { buckle } from '../buckling/buckle.ts'
import type { FilmNoise } from '../buckling/film-noise.ts'
import { flatChart } from '../buckling/flat-chart.ts'
import { Relief } from '../buckling/relief.ts'
import { type ChartSamples, liftLine, sampleAt, sampleChart } from '../buckling/sample-chart.ts'
import { reversedValley, traceValleys, type Valley } from '../buckling/valleys.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import { type ChartPoint, type HeadChart, unroll, unrollPoint } from '../surface/head-chart.ts'
import { type FilmFields, filmFields } from './film-fields.ts'
import { keptRuns, type LaidLine } from './laid-line.ts'
import { STEP } from './trace.ts'

/** Maximum distance between samples of the film in millimetres. Wrinkles of the thinnest skin are about three samples wide. */
const SPACING = 1.5
/** Minimum distance between the skin and its periodic copy in millimetres. */
const MARGIN = 8
/** Skin folds only if the cosine between its normal and the head's outward direction exceeds this. */
const FACING = 0.1
/** Skin folds only if its depth below the outermost skin is less than this, in millimetres. */
const HIDDEN = 4
/** Minimum weight of the compression at a line. */
const MIN_WEIGHT = 0.05
/** Minimum depth of a line below the mean height, in millimetres. */
const MIN_DEPTH = 0.07
/** Minimum length of a line, as a multiple of the region's `spacing`. */
const MIN_LENGTH = 1.2
/** Lines run across the muscle's pull. Minimum mean cosine of the angle between a line and this direction. */
const ALIGNED = 0.8
/** Width of the shallowest lines, as a fraction of the width of the deepest line. */
const NARROWEST = 0.75

/** Samples and fields of a folded film, and the valleys between its ridges. */
interface FoldedFilm {
  samples: ChartSamples
  fields: FilmFields
  valleys: readonly Valley[]
}

/**
 * Lays lines along the valleys of skin that buckles.
 *
 * @param tensors result of `compressionTensors` for the region's expression.
 * @param report called with the fraction done.
 * @returns the lines; empty if the mesh has no skin in the region, or if the skin buckles too little.
 */
export function layFilm(
  face: Pick<DetectedFace, 'surface' | 'chart'>,
  region: Pick<BucklingRegion, 'film' | 'creasedFraction' | 'spacing'>,
  tensors: Float64Array,
  report: (fraction: number) => void,
): LaidLine[] {
  const folded = foldFilm(face, region, tensors, report)
  if (!folded) return []
  const { samples, fields, valleys } = folded
  return layValleys(samples, fields, valleys, region.film.style)
}

/** Computes the valleys of a region's film. Returns undefined if the mesh has no skin there. */
function foldFilm(
  { surface, chart: head }: Pick<DetectedFace, 'surface' | 'chart'>,
  { film, creasedFraction, spacing }: Pick<BucklingRegion, 'film' | 'creasedFraction' | 'spacing'>,
  tensors: Float64Array,
  report: (fraction: number) => void,
): FoldedFilm | undefined {
  const positionOnHead = (point: number): ChartPoint => {
    const [across, up] = unrollPoint(surface.points, point)
    return [across - film.centre[0], up - film.centre[1]]
  }
  const chart = flatChart(surface, (point) => isFolding(surface, head, film, point), positionOnHead)
  if (!chart) return undefined
  const samples = sampleChart(chart, SPACING / Math.max(1, film.density), MARGIN)
  const fields = filmFields(samples, film, tensors)
  const limits = { minWeight: MIN_WEIGHT, minLength: MIN_LENGTH * spacing }
  const valleys = foldValleys(samples, fields, { creasedFraction, noise: film.noise, ...limits }, report)
  return {
    samples,
    fields,
    valleys: valleys
      .filter((valley) => alignment(samples, fields, valley) > ALIGNED)
      .map((valley) => outwards(samples, valley, film.centre)),
  }
}

/** How a film buckles, and which of its valleys become lines. */
export interface Folding {
  /** Fraction of the compression that becomes creases. */
  creasedFraction: number
  noise: FilmNoise
  /** Minimum weight of the compression at a line. */
  minWeight: number
  /** Minimum length of a line in millimetres. */
  minLength: number
}

/** Lets a film buckle, and traces its valleys. */
export function foldValleys(
  samples: ChartSamples,
  { compression, wavelength, critical, weight }: Omit<FilmFields, 'pull'>,
  { creasedFraction, noise, minWeight, minLength }: Folding,
  report?: (fraction: number) => void,
): Valley[] {
  const { grid, origin } = samples
  const [xx, xy, yy] = compression.map((part) => part.map((value) => creasedFraction * value))
  const film = { grid, origin, compression: [xx, xy, yy], wavelength, critical, noise } as const
  return traceValleys(new Relief(grid, buckle(film, report)), {
    step: STEP,
    wavelength: (x, y) => wavelength[sampleAt(samples, x, y)],
    isInside: (x, y) => weight[sampleAt(samples, x, y)] > minWeight,
    minDepth: MIN_DEPTH,
    minLength,
  })
}

/** Returns whether a point is inside the film's patch and on outer skin. */
function isFolding(surface: SkinSurface, head: HeadChart, film: SkinFilm, point: number): boolean {
  if (!film.isFlattened(unrollPoint(surface.points, point))) return false
  const [x, y, z] = surface.points.subarray(3 * point, 3 * point + 3)
  const { facing, depth } = head.exposure(x, y, z, surface.normals.subarray(3 * point, 3 * point + 3))
  return facing > FACING && depth < HIDDEN
}

/** Returns the mean cosine of the angle between a valley and the perpendicular to the muscle's pull. */
function alignment(samples: ChartSamples, { pull: [pullX, pullY] }: FilmFields, { points }: Valley): number {
  let sum = 0
  for (let i = 0; i + 3 < points.length; i += 2) {
    const [dx, dy] = [points[i + 2] - points[i], points[i + 3] - points[i + 1]]
    const sample = sampleAt(samples, points[i], points[i + 1])
    sum += Math.abs(dx * pullY[sample] - dy * pullX[sample]) / (length2(dx, dy) || 1)
  }
  return sum / (points.length / 2 - 1)
}

/** Lets a valley start at the end that is nearer to a point of the head's chart. */
function outwards(samples: ChartSamples, valley: Valley, [across, up]: ChartPoint): Valley {
  const [first] = liftLine(samples, valley.points.slice(0, 2))
  const [last] = liftLine(samples, valley.points.slice(-2))
  if (!first || !last) return valley
  const distanceTo = ({ position: [x, y, z] }: SurfacePoint) => {
    const point = unroll(x, y, z)
    return length2(point[0] - across, point[1] - up)
  }
  return distanceTo(first) <= distanceTo(last) ? valley : reversedValley(valley)
}

/**
 * Lifts valleys onto the surface. Where the skin has a hole, a line is cut.
 *
 * @param style style of the deepest line.
 */
export function layValleys(
  samples: ChartSamples,
  fields: Pick<FilmFields, 'compression'>,
  valleys: readonly Valley[],
  style: LineStyle,
): LaidLine[] {
  const deepest = valleys.reduce((most, { depths }) => Math.max(most, ...depths), 0)
  return valleys.flatMap((valley) => layValley(samples, fields, valley, style, deepest))
}

/** @param deepest depth of the deepest valley in millimetres. */
function layValley(
  samples: ChartSamples,
  fields: Pick<FilmFields, 'compression'>,
  { points, depths, joins }: Valley,
  style: LineStyle,
  deepest: number,
): LaidLine[] {
  const most = Math.max(...depths)
  const share = most / deepest
  const count = depths.length
  const sampleOf = (i: number) => sampleAt(samples, points[2 * i], points[2 * i + 1])
  const lifted = liftLine(samples, points)
  return keptRuns(count, (i) => lifted[i] !== undefined).map(([start, end]) => {
    const part = lifted.slice(start, end) as SurfacePoint[]
    return {
      style: {
        ...style,
        width: style.width * (NARROWEST + (1 - NARROWEST) * share),
        depth: style.depth * share,
        taper: [start > 0 || joins[0] ? 0 : style.taper[0], end < count || joins[1] ? 0 : style.taper[1]],
      },
      points: Float64Array.from(part.flatMap(({ position }) => [...position])),
      triangles: part.map(({ triangle }) => triangle),
      compressions: part.map((_, k) => compressionAcross(fields, sampleOf(start + k), points, start + k)),
      relativeDepths: depths.slice(start, end).map((depth) => depth / most),
    }
  })
}

/** Returns the compression across a line at one of its points. */
function compressionAcross(
  { compression: [xx, xy, yy] }: Pick<FilmFields, 'compression'>,
  sample: number,
  points: readonly number[],
  i: number,
): number {
  const [before, after] = [2 * Math.max(i - 1, 0), Math.min(2 * i + 2, points.length - 2)]
  const [dx, dy] = [points[after] - points[before], points[after + 1] - points[before + 1]]
  const square = dx * dx + dy * dy || 1
  return (xx[sample] * dy * dy - 2 * xy[sample] * dx * dy + yy[sample] * dx * dx) / square
}
