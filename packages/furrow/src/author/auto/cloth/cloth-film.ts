import { exp } from '../../../math/elementary.ts'
import { clamp, smoothstep } from '../../../math/scalar.ts'
import { length2, normalize } from '../../../math/vector.ts'
import { cornersOf, type SkinSurface } from '../../skin/surface.ts'
import { buckle } from '../buckling/buckle.ts'
import { filmNoise } from '../buckling/film-noise.ts'
import { placedChart } from '../buckling/flat-chart.ts'
import {
  type ChartSamples,
  chartAxes,
  sampleChart,
  sampleTensors,
  sampleValues,
} from '../buckling/sample-chart.ts'
import { softlyClamped } from '../limbs/clamp.ts'
import type { LimbPoint } from '../limbs/limb-chart.ts'
import { type Compression, flatPosition, limitPrincipal } from '../lines/film-fields.ts'
import { fieldSmoother } from './smooth-field.ts'

/** Cloth around a limb. The limb's own cylinder is the chart, so texture seams do not matter. */
export interface ClothTube {
  /** Returns the angle of a point around the tube in radians, -pi..pi, and the distance along it in millimetres. */
  place(point: number): LimbPoint
  /** Mean radius of the tube in millimetres. */
  radius: number
  /** Returns the weight of the compression at a point, 0..1. Points with 0 are not flattened. */
  weight(point: number): number
  /** Returns the weight of the folds at a point, 0..1, without effect on the compression. */
  shown(point: number): number
  /** Distance between folds in millimetres. */
  wavelength: number
  /** Number of samples of the cloth per wavelength. */
  samples: number
  /** Minimum length of a fold in wavelengths. */
  shortest: number
  /**
   * Returns the slope by which the compression turns at a position: angle around the tube in radians, and distance along it. Folds spread
   * like a fan from the crook.
   */
  fan(angle: number, along: number): number
  /** Fraction of the compression that acts along the tube, 0..1. */
  directed: number
  /** Standard deviation of the random turn of the compression, as a slope. */
  lean: number
  /** Compression at which the cloth buckles. */
  critical: number
  /** Standard deviation of the logarithm of a fold's share of the compression. */
  unevenness: number
  /** Standard deviation of the random change of weights of 0.5. Weights of 0 and 1 stay the same. */
  ragged: number
  seed: number
}

/** Buckled cloth: heights at the samples of a chart, in millimetres. */
export interface BuckledCloth {
  samples: ChartSamples
  heights: Float64Array
  /** Compression per sample, and the part of it that folds take up. */
  lost: Float64Array
  wanted: Float64Array
  /** Unit direction of the largest compression, per sample. */
  across: readonly [x: Float64Array, y: Float64Array]
  weight: Float64Array
  /** Weight of the folds per sample, 0..1. */
  shown: Float64Array
  /** Local distance between folds, per sample. */
  wavelength: Float64Array
}

/** Distance between the cloth and its periodic copy, in wavelengths. */
const MARGIN = 1
/** Wavelength at which the equation is solved, because its coefficients hold for millimetres of skin. */
export const SOLVED = 12
/** Folds of strongly compressed cloth are closer than the wavelength at the onset of buckling, by this factor. */
const CLOSER = 0.8
/** Compression up to which folds take up the lost length. More would need folds that are deeper than wide. */
const TAKEN_UP = 0.15
/** Relative deviations of the wavelength and of the logarithm of the critical compression, and size of the irregularities in wavelengths. */
const VARIATION = { wavelength: 0.26, critical: 0.45, size: 1.5 } as const
/** Size of the random turns of the compression, in wavelengths. Folds lean, meet and fork. */
const LEAN_SIZE = 1.2
/** Size of the variation of shares of the compression, in wavelengths. */
const SHARE_SIZE = 1.1
/** Size of the random changes of weights, in wavelengths. */
const RAGGED_SIZE = 0.9
/** Standard deviation, in wavelengths, of the Gaussian that compares taken up and lost length. */
const LOCAL = 0.45
/** Limit of the factor on the heights that corrects the length. */
const MAX_GAIN = 2
/** Compressions at which folds begin, and at which they take up the whole loss. */
const ONSET = [0.02, 0.07] as const

/** Lets the cloth of a tube buckle. Returns undefined if the mesh has no cloth there. */
export function buckleCloth(
  surface: SkinSurface,
  tube: ClothTube,
  tensors: Float64Array,
): BuckledCloth | undefined {
  const { radius, wavelength: lambda } = tube
  const placeAt = (point: number) => {
    const [angle, along] = tube.place(point)
    return [radius * angle, along] as const
  }
  const weights = Float64Array.from(surface.areas, (_, point) => tube.weight(point))
  const chart = placedChart(surface, tubeTriangles(surface, weights, placeAt, Math.PI * radius), placeAt)
  if (!chart) return undefined
  const samples = sampleChart(chart, lambda / tube.samples, MARGIN * lambda)
  const smooth = sampleValues(
    samples,
    Array.from(chart.points, (point) => weights[point]),
  )
  const weight = raggedWeights(samples, smooth, tube)
  // Unit axes, because the radius of the tube varies.
  const axes = chartAxes(chart)
  for (let i = 0; i < axes.length; i += 3) normalize(axes, i)
  const shown = sampleValues(samples, Array.from(chart.points, tube.shown))
  const compression = sampleTensors(samples, tensors, axes)
  limitPrincipal(compression, softlyClamped)
  direct(compression, tube.directed)
  turn(samples, compression, tube)
  for (const part of compression) for (let i = 0; i < part.length; i++) part[i] *= weight[i]
  const { wavelength, heights } = solve(samples, compression, tube)
  const { across, lost, wanted } = principal(compression)
  correctLength(samples, heights, { across, wanted }, tube)
  return {
    samples,
    heights,
    lost,
    wanted,
    across,
    weight,
    shown: fieldSmoother(samples.grid, 0.2 * lambda)(shown),
    wavelength,
  }
}

/** Changes weights at random where they fade, so that folds do not all end at one border. */
function raggedWeights(samples: ChartSamples, weights: Float64Array, tube: ClothTube): Float64Array {
  if (tube.ragged === 0) return weights
  const noise = filmNoise(tube.seed + 53)
  return weights.map((weight, i) => {
    if (!(weight > 0 && weight < 1)) return weight
    const vary = noise(...flatPosition(samples, i), RAGGED_SIZE * tube.wavelength, 6)
    return clamp(weight + 4 * weight * (1 - weight) * tube.ragged * vary, 0, 1)
  })
}

/** Returns the triangles of a tube on which the cloth may fold, without those that cross the border of the chart. */
function tubeTriangles(
  surface: SkinSurface,
  weights: Float64Array,
  placeAt: (point: number) => readonly [x: number, y: number],
  half: number,
): Uint32Array {
  return Uint32Array.from(surface.skinTriangles.keys()).filter((triangle) => {
    const own = cornersOf(surface, triangle)
    if (!own.every((point) => weights[point] > 0)) return false
    const xs = own.map((point) => placeAt(point)[0])
    return Math.max(...xs) - Math.min(...xs) < half
  })
}

/** Solves the equation of buckling at the wavelength for which its coefficients hold, and scales the result back. */
function solve(
  samples: ChartSamples,
  compression: Compression,
  { wavelength: lambda, critical, seed }: ClothTube,
) {
  const noise = filmNoise(seed)
  const scale = SOLVED / lambda
  const { grid, origin } = samples
  const size = VARIATION.size * lambda
  const count = grid.width * grid.height
  const relative = Float64Array.from(
    { length: count },
    (_, i) => 1 + VARIATION.wavelength * noise(...flatPosition(samples, i), size, 2),
  )
  const film = {
    grid: { ...grid, spacing: scale * grid.spacing },
    origin: [scale * origin[0], scale * origin[1]] as const,
    compression,
    wavelength: relative.map((value) => (SOLVED * value) / CLOSER),
    critical: relative.map(
      (_, i) => critical * exp(VARIATION.critical * noise(...flatPosition(samples, i), size, 3)),
    ),
    noise,
  }
  return {
    heights: buckle(film).map((height) => height / scale),
    wavelength: relative.map((value) => lambda * value),
  }
}

/** Turns a fraction of the compression to the direction along the tube, in place. */
function direct([xx, xy, yy]: Compression, fraction: number): void {
  for (let i = 0; i < xx.length; i++) {
    const largest = (xx[i] + yy[i]) / 2 + length2((xx[i] - yy[i]) / 2, xy[i])
    xx[i] *= 1 - fraction
    xy[i] *= 1 - fraction
    yy[i] = (1 - fraction) * yy[i] + fraction * largest
  }
}

/** Turns the compression by the fan and at random, in place. */
function turn(samples: ChartSamples, [xx, xy, yy]: Compression, tube: ClothTube): void {
  const noise = filmNoise(tube.seed + 31)
  for (let i = 0; i < xx.length; i++) {
    const [x, y] = flatPosition(samples, i)
    const random = tube.lean * clamp(noise(x, y, LEAN_SIZE * tube.wavelength, 4), -1.6, 1.6)
    const slope = random + tube.fan(x / tube.radius, y)
    const size = length2(1, slope)
    const [c, s] = [1 / size, slope / size]
    const [a, b, d] = [xx[i], xy[i], yy[i]]
    xx[i] = c * c * a - 2 * c * s * b + s * s * d
    xy[i] = c * s * a + (c * c - s * s) * b - c * s * d
    yy[i] = s * s * a + 2 * c * s * b + c * c * d
  }
}

/** Returns the largest compression of each sample, its direction, and the part of it that folds take up. */
function principal([xx, xy, yy]: Compression): Pick<BuckledCloth, 'across' | 'lost' | 'wanted'> {
  const [x, y, lost] = [xx, xx, xx].map(({ length }) => new Float64Array(length))
  for (let i = 0; i < xx.length; i++) {
    const half = (xx[i] - yy[i]) / 2
    const radius = length2(half, xy[i])
    const [dx, dy] = half > 0 ? [half + radius, xy[i]] : [xy[i], radius - half]
    const size = length2(dx, dy)
    ;[x[i], y[i]] = size > 0 ? [dx / size, dy / size] : [0, 1]
    lost[i] = Math.max(0, (xx[i] + yy[i]) / 2 + radius)
  }
  return { across: [x, y], lost, wanted: lost.map((value) => Math.min(TAKEN_UP, value)) }
}

/** Scales the heights in place, so that the folds take up the lost length. Some folds take more than their share, and their neighbours less. */
function correctLength(
  samples: ChartSamples,
  heights: Float64Array,
  { across: [ax, ay], wanted }: Pick<BuckledCloth, 'across' | 'wanted'>,
  { wavelength: lambda, unevenness, seed }: ClothTube,
): void {
  const { grid } = samples
  const { width, height, spacing } = grid
  const noise = filmNoise(seed + 7)
  const local = fieldSmoother(grid, LOCAL * lambda)
  const taken = new Float64Array(heights.length)
  const shares = new Float64Array(heights.length)
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const i = y * width + x
      const [left, right] = [y * width + ((x + width - 1) % width), y * width + ((x + 1) % width)]
      const [above, below] = [((y + height - 1) % height) * width + x, ((y + 1) % height) * width + x]
      const slope =
        (ax[i] * (heights[right] - heights[left]) + ay[i] * (heights[below] - heights[above])) / (2 * spacing)
      taken[i] = 0.5 * slope * slope
      const vary = noise(...flatPosition(samples, i), SHARE_SIZE * lambda, 5)
      shares[i] = wanted[i] * exp(unevenness * vary - unevenness ** 2 / 2)
    }
  }
  const [got, want, whole] = [local(taken), local(shares), local(wanted)]
  // The onset depends on the whole loss. Otherwise small shares would leave smooth patches among the folds.
  const gain = got.map(
    (value, i) =>
      Math.min(MAX_GAIN, Math.sqrt(Math.max(0, want[i]) / Math.max(value, 1e-5))) *
      smoothstep((whole[i] - ONSET[0]) / (ONSET[1] - ONSET[0])),
  )
  const smoothGain = fieldSmoother(grid, 0.5 * LOCAL * lambda)(gain)
  for (let i = 0; i < heights.length; i++) heights[i] *= Math.max(0, smoothGain[i])
}
