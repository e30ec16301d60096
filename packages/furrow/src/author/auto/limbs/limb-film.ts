import { exp } from '../../../math/elementary.ts'
import { clamp } from '../../../math/scalar.ts'
import { length2 } from '../../../math/vector.ts'
import type { SkinSurface } from '../../skin/surface.ts'
import type { LineStyle } from '../anatomy/region.ts'
import { buckle } from '../buckling/buckle.ts'
import { CRITICAL_COMPRESSION, filmWavelength } from '../buckling/film.ts'
import { filmNoise } from '../buckling/film-noise.ts'
import { flatChart } from '../buckling/flat-chart.ts'
import { Relief } from '../buckling/relief.ts'
import {
  type ChartSamples,
  sampleAt,
  sampleChart,
  sampleTensors,
  sampleValues,
} from '../buckling/sample-chart.ts'
import { traceValleys } from '../buckling/valleys.ts'
import { layValley } from '../lines/film-lines.ts'
import type { LaidLine } from '../lines/laid-line.ts'
import { STEP } from '../lines/trace.ts'
import { softlyClamped } from './clamp.ts'
import { aroundLimb, type LimbFrame } from './limb-chart.ts'
import type { Vector } from './limb-skin.ts'

/** Skin of a limb that buckles. The limb's own cylinder is the chart, so texture seams do not matter. */
export interface LimbFilm {
  frame: LimbFrame
  /** Mean radius of the limb in millimetres. */
  radius: number
  /** Returns the weight of the compression at a point, 0..1. Points with 0 are not flattened. */
  weight(point: number): number
  /** Thickness of the dermis in millimetres. */
  thickness: number
  /** Direction across the folds, around and along the limb. */
  pull: readonly [around: number, along: number]
  /** Fraction of the compression that acts along the pull. */
  directed: number
  /** Compression that is added along the pull. */
  added: number
  seed: number
  style: LineStyle
}

/** Number of samples of the film per wavelength. */
const SAMPLES = 6
/** Minimum distance between the skin and its periodic copy in millimetres. */
const MARGIN = 12
/** Standard deviation of the relative thickness and of the logarithm of the critical compression, and size of the irregularities in mm. */
const VARIATION = { thickness: 0.14, critical: 0.35, size: 16 }
/** Standard deviation of the random turn of the pull, as a slope, and size of its bumps in millimetres. Folds lean, meet and fork. */
const LEAN = { slope: 0.22, size: 26 }
const MIN_WEIGHT = 0.12
/** Minimum depth of a line below the mean height, in millimetres. */
const MIN_DEPTH = 0.07
/** Minimum length of a line in wavelengths. */
const MIN_LENGTH = 1.3

/** Lays lines along the valleys of a limb's skin that buckles. */
export function layLimbFilm(
  surface: SkinSurface,
  film: LimbFilm,
  tensors: Float64Array,
  creasedFraction: number,
): LaidLine[] {
  const { frame, radius, thickness, style, seed } = film
  const placeAt = (point: number) => {
    const { points } = surface
    const at: Vector = [points[3 * point], points[3 * point + 1], points[3 * point + 2]]
    const { angle, along } = aroundLimb(frame, at)
    return [radius * angle, along] as const
  }
  const weights = Float64Array.from(surface.areas, (_, point) => film.weight(point))
  const chart = flatChart(surface, (point) => weights[point] > 0, placeAt)
  if (!chart) return []
  const spacing = filmWavelength(thickness)
  const samples = sampleChart(chart, spacing / SAMPLES, MARGIN)
  const weight = sampleValues(
    samples,
    Array.from(chart.points, (point) => weights[point]),
  )
  const noise = filmNoise(seed)
  const compression = pulled(samples, sampleTensors(samples, tensors), weight, film)
  const noiseAt = (i: number, stream: number) => {
    const { grid, origin } = samples
    const [x, y] = [
      origin[0] + (i % grid.width) * grid.spacing,
      origin[1] + Math.floor(i / grid.width) * grid.spacing,
    ]
    return noise(x, y, VARIATION.size, stream)
  }
  const wavelength = weight.map((_, i) =>
    filmWavelength(thickness * (1 + VARIATION.thickness * noiseAt(i, 2))),
  )
  const critical = weight.map((_, i) => CRITICAL_COMPRESSION * exp(VARIATION.critical * noiseAt(i, 3)))
  const [xx, xy, yy] = compression.map((part) => part.map((value) => creasedFraction * value))
  const { grid, origin } = samples
  const heights = buckle({ grid, origin, compression: [xx, xy, yy], wavelength, critical, noise })
  const valleys = traceValleys(new Relief(grid, heights), {
    step: STEP,
    wavelength: (x, y) => wavelength[sampleAt(samples, x, y)],
    isInside: (x, y) => weight[sampleAt(samples, x, y)] > MIN_WEIGHT,
    minDepth: MIN_DEPTH,
    minLength: MIN_LENGTH * spacing,
  })
  const deepest = valleys.reduce((most, { depths }) => Math.max(most, ...depths), 0)
  return valleys.flatMap((valley) => layValley(samples, { compression }, valley, style, deepest))
}

type Compression = [xx: Float64Array, xy: Float64Array, yy: Float64Array]

/** Turns a part of the compression to the direction of the pull, limits it smoothly, and multiplies it by the weight. */
function pulled(
  { grid, origin }: ChartSamples,
  [xx, xy, yy]: Compression,
  weight: Float64Array,
  { pull, directed, added, seed }: LimbFilm,
): Compression {
  const noise = filmNoise(seed)
  for (let i = 0; i < weight.length; i++) {
    const [px, py] = [
      origin[0] + (i % grid.width) * grid.spacing,
      origin[1] + Math.floor(i / grid.width) * grid.spacing,
    ]
    const lean = LEAN.slope * clamp(noise(px, py, LEAN.size, 4), -1.6, 1.6)
    const size = length2(1, lean)
    const [x, y] = [(pull[0] - lean * pull[1]) / size, (pull[1] + lean * pull[0]) / size]
    const along = xx[i] * x * x + 2 * xy[i] * x * y + yy[i] * y * y
    const own = softlyClamped(added + directed * along)
    const rest = limited((1 - directed) * xx[i], (1 - directed) * xy[i], (1 - directed) * yy[i])
    xx[i] = weight[i] * (rest[0] + own * x * x)
    xy[i] = weight[i] * (rest[1] + own * x * y)
    yy[i] = weight[i] * (rest[2] + own * y * y)
  }
  return [xx, xy, yy]
}

/** Limits the principal compressions of a tensor smoothly. */
function limited(xx: number, xy: number, yy: number): readonly [xx: number, xy: number, yy: number] {
  const half = (xx - yy) / 2
  const radius = length2(half, xy)
  const mean = (xx + yy) / 2
  const [high, low] = [softlyClamped(mean + radius), softlyClamped(mean - radius)]
  const scale = radius > 0 ? (high - low) / (2 * radius) : 0
  return [(high + low) / 2 + scale * half, scale * xy, (high + low) / 2 - scale * half]
}
