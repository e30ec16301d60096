import { exp } from '../../../math/elementary.ts'
import { clamp, lerp } from '../../../math/scalar.ts'
import { dot, length2, unit2 } from '../../../math/vector.ts'
import type { SkinFilm } from '../anatomy/region.ts'
import type { Film } from '../buckling/buckle.ts'
import { CRITICAL_COMPRESSION, filmWavelength } from '../buckling/film.ts'
import type { FilmNoise } from '../buckling/film-noise.ts'
import { type ChartSamples, chartAxes, sampleTensors, sampleValues } from '../buckling/sample-chart.ts'
import { rollUp, unrollPoint } from '../surface/head-chart.ts'

/** Maximum compression that is added along a muscle's pull. */
const MAX_PULL = 0.13
/** Ratio of the added compression to a typical measured one. It exceeds 1 because simple blendshapes move less skin than the muscle. */
const PULL = 2
/** Fraction of the skin whose compression along the pull is greater than the typical one, which is thus its 90th percentile. */
const PULLED = 0.1
/** Skin counts for `PULLED` only if the weight of its compression (`FilmFields.weight`) is at least this. */
const FULL_WEIGHT = 0.5
/** Fraction of the measured compression that is turned to the direction of the pull. */
const DIRECTED = 0.7
/**
 * Range to which the compression is clamped. Stronger stretch does not make the skin flatter. Stronger compression occurs at the lids, where
 * skin moves together without folding.
 */
const COMPRESSIONS = [-0.15, 0.2] as const

/** Fields of a film at samples of its chart. */
export interface FilmFields extends Pick<Film, 'compression' | 'wavelength' | 'critical'> {
  /** Weight of the compression, 0..1; 0 outside the chart. */
  weight: Float64Array
  /** Unit direction of the muscle's pull in the axes of the chart; 0 outside the chart. */
  pull: readonly [x: Float64Array, y: Float64Array]
}

/**
 * Computes the compression of a film, and its randomly varying wavelength and critical compression.
 *
 * @param tensors result of `compressionTensors` for the expression.
 */
export function filmFields(samples: ChartSamples, film: SkinFilm, tensors: Float64Array): FilmFields {
  const { chart } = samples
  const { variation, noise } = film
  const onHead = Array.from(chart.points, (point) => unrollPoint(chart.surface.points, point))
  const weight = sampleValues(samples, onHead.map(film.weight))
  // Thinner films fold into more wrinkles.
  const thickness = sampleValues(
    samples,
    onHead.map((point) => film.thickness(point) / film.density),
  )
  const pull = samplePull(samples, film)
  const compression = sampleTensors(samples, tensors)
  turnToPull(compression, pull, weight, film.evenness)
  limitPrincipal(compression, (value) => clamp(value, ...COMPRESSIONS))
  for (const part of compression) for (let i = 0; i < part.length; i++) part[i] *= weight[i]
  return { compression, ...variedFilm(samples, thickness, variation, noise), weight, pull }
}

/**
 * Returns the randomly varying wavelength and critical compression of a film.
 *
 * @param thickness thickness of the dermis at each sample in millimetres. Samples with 0 get the mean of the others.
 */
export function variedFilm(
  samples: ChartSamples,
  thickness: Float64Array,
  variation: SkinFilm['variation'],
  noise: FilmNoise,
): Pick<FilmFields, 'wavelength' | 'critical'> {
  const skin = thickness.filter((value) => value > 0)
  const mean = skin.reduce((sum, value) => sum + value, 0) / skin.length
  const noiseAt = (i: number, stream: number) => noise(...flatPosition(samples, i), variation.size, stream)
  return {
    wavelength: thickness.map((value, i) =>
      filmWavelength((value || mean) * (1 + variation.thickness * noiseAt(i, 2))),
    ),
    critical: thickness.map((_, i) => CRITICAL_COMPRESSION * exp(variation.critical * noiseAt(i, 3))),
  }
}

/** Returns the flat position of a sample in millimetres. */
export function flatPosition(
  { grid: { width, spacing }, origin }: ChartSamples,
  i: number,
): [x: number, y: number] {
  return [origin[0] + (i % width) * spacing, origin[1] + Math.floor(i / width) * spacing]
}

/** Samples the direction of the muscle's pull in the axes of the chart. */
function samplePull(samples: ChartSamples, film: SkinFilm): readonly [x: Float64Array, y: Float64Array] {
  const { chart } = samples
  const { points, normals } = chart.surface
  const axes = chartAxes(chart)
  const direction = new Float64Array(3)
  const [x, y] = [new Float64Array(chart.points.length), new Float64Array(chart.points.length)]
  for (const [i, point] of chart.points.entries()) {
    const normal = normals.subarray(3 * point, 3 * point + 3)
    rollUp(points[3 * point], points[3 * point + 2], normal, film.pull(unrollPoint(points, point)), direction)
    x[i] = dot(direction, axes.subarray(6 * i, 6 * i + 3))
    y[i] = dot(direction, axes.subarray(6 * i + 3, 6 * i + 6))
  }
  const [across, up] = [sampleValues(samples, x), sampleValues(samples, y)]
  for (let i = 0; i < across.length; i++) [across[i], up[i]] = unit2(across[i], up[i])
  return [across, up]
}

/** Components of compression tensors, one per sample. */
export type Compression = [xx: Float64Array, xy: Float64Array, yy: Float64Array]

/** Limits the principal compressions of tensors, in place. */
export function limitPrincipal([xx, xy, yy]: Compression, limited: (compression: number) => number): void {
  for (let i = 0; i < xx.length; i++) {
    const half = (xx[i] - yy[i]) / 2
    const radius = length2(half, xy[i])
    const mean = (xx[i] + yy[i]) / 2
    const [high, low] = [limited(mean + radius), limited(mean - radius)]
    const scale = radius > 0 ? (high - low) / (2 * radius) : 0
    xx[i] = (high + low) / 2 + scale * half
    yy[i] = (high + low) / 2 - scale * half
    xy[i] *= scale
  }
}

/** Returns the compression in the direction of the pull at each sample. */
export function compressionAlongPull([xx, xy, yy]: Compression, [x, y]: FilmFields['pull']): Float64Array {
  return xx.map((_, i) => xx[i] * x[i] * x[i] + 2 * xy[i] * x[i] * y[i] + yy[i] * y[i] * y[i])
}

/**
 * Turns the compression towards the muscle's pull, because blendshapes show the direction of the pull only roughly. Also adds compression
 * along the pull, because blendshapes compress only a part of the skin on which the muscle acts.
 */
function turnToPull(
  [xx, xy, yy]: Compression,
  [x, y]: FilmFields['pull'],
  weight: Float64Array,
  evenness = 0,
): void {
  const along = compressionAlongPull([xx, xy, yy], [x, y])
  const pulled = along.filter((_, i) => weight[i] >= FULL_WEIGHT).sort((a, b) => b - a)
  const added = clamp(PULL * (pulled[Math.floor(PULLED * pulled.length)] ?? 0), 0, MAX_PULL)
  const even = pulled.length > 0 ? pulled.reduce((sum, value) => sum + value, 0) / pulled.length : 0
  for (let i = 0; i < weight.length; i++) {
    const pull = added + DIRECTED * lerp(along[i], even, evenness)
    xx[i] = (1 - DIRECTED) * xx[i] + pull * x[i] * x[i]
    xy[i] = (1 - DIRECTED) * xy[i] + pull * x[i] * y[i]
    yy[i] = (1 - DIRECTED) * yy[i] + pull * y[i] * y[i]
  }
}
