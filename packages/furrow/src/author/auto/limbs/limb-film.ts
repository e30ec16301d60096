import { clamp } from '../../../math/scalar.ts'
import { length2 } from '../../../math/vector.ts'
import { vectorAt } from '../../../math/vector3.ts'
import type { SkinSurface } from '../../skin/surface.ts'
import type { LineStyle } from '../anatomy/region.ts'
import { filmWavelength } from '../buckling/film.ts'
import { type FilmNoise, filmNoise } from '../buckling/film-noise.ts'
import { flatChart } from '../buckling/flat-chart.ts'
import { type ChartSamples, sampleChart, sampleTensors, sampleValues } from '../buckling/sample-chart.ts'
import {
  type Compression,
  compressionAlongPull,
  flatPosition,
  limitPrincipal,
  variedFilm,
} from '../lines/film-fields.ts'
import { foldValleys, layValleys } from '../lines/film-lines.ts'
import type { LaidLine } from '../lines/laid-line.ts'
import { softlyClamped } from './clamp.ts'
import { aroundLimb, type LimbFrame } from './limb-chart.ts'

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
/** Minimum weight of the compression at a line. */
const MIN_WEIGHT = 0.12
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
    const { angle, along } = aroundLimb(frame, vectorAt(surface.points, point))
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
  const compression = sampleTensors(samples, tensors)
  turnToPull(samples, compression, weight, film, noise)
  const varied = variedFilm(samples, new Float64Array(weight.length).fill(thickness), VARIATION, noise)
  const limits = { minWeight: MIN_WEIGHT, minLength: MIN_LENGTH * spacing }
  const folding = { creasedFraction, noise, ...limits }
  const valleys = foldValleys(samples, { compression, ...varied, weight }, folding)
  return layValleys(samples, { compression }, valleys, style)
}

/** Turns a part of the compression to the direction of the pull, limits it smoothly, and multiplies it by the weight, in place. */
function turnToPull(
  samples: ChartSamples,
  compression: Compression,
  weight: Float64Array,
  { pull, directed, added }: LimbFilm,
  noise: FilmNoise,
): void {
  const [x, y] = [new Float64Array(weight.length), new Float64Array(weight.length)]
  for (let i = 0; i < weight.length; i++) {
    const lean = LEAN.slope * clamp(noise(...flatPosition(samples, i), LEAN.size, 4), -1.6, 1.6)
    const size = length2(1, lean)
    x[i] = (pull[0] - lean * pull[1]) / size
    y[i] = (pull[1] + lean * pull[0]) / size
  }
  const along = compressionAlongPull(compression, [x, y])
  for (const part of compression) for (let i = 0; i < part.length; i++) part[i] *= 1 - directed
  limitPrincipal(compression, softlyClamped)
  const [xx, xy, yy] = compression
  for (let i = 0; i < weight.length; i++) {
    const own = softlyClamped(added + directed * along[i])
    xx[i] = weight[i] * (xx[i] + own * x[i] * x[i])
    xy[i] = weight[i] * (xy[i] + own * x[i] * y[i])
    yy[i] = weight[i] * (yy[i] + own * y[i] * y[i])
  }
}
