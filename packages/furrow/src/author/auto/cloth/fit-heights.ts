import { clamp, lerp, smoothstep } from '../../../math/scalar.ts'
import { length2 } from '../../../math/vector.ts'
import { bulgeAt } from '../../strokes/profile.ts'
import { type ChartSamples, sampleAt } from '../buckling/sample-chart.ts'
import type { BuckledCloth } from './cloth-film.ts'
import type { Ridge } from './ridges.ts'
import { fieldSmoother } from './smooth-field.ts'

/** Samples that a ridge raises: their indices, the factor on the height, and the index of the nearest point. */
interface Footprint {
  samples: number[]
  factors: number[]
  nearest: number[]
}

/** Rounds of the correction of heights where folds overlap. */
const ROUNDS = 8
/** Number of points on both sides over which factors on the height are averaged: half a wavelength. */
const WINDOW = 8
/** Length over which a free end of a fold fades out, in reaches, up to half of the fold. */
const FADE = 3.2
/** Compressions from which on the arc length of the folds begins to count, and from which on it counts completely. */
const COMPARED = [0.01, 0.07] as const
/** Standard deviation, in wavelengths, of the Gaussian over which taken up and lost length are compared. */
const LOCAL = 0.9
/** Range of the factor by which one pass corrects heights, and number of passes. */
const GAIN = [0.7, 1.25] as const
const PASSES = 4

/**
 * Computes the heights of folds, which are drawn as bulges along their crests. Where folds overlap, their heights add up, so each becomes lower.
 *
 * @returns heights per point of each ridge, in millimetres.
 */
export function fitHeights(
  cloth: BuckledCloth,
  ridges: readonly Ridge[],
  { wavelength, limit }: { wavelength: number; limit: number },
): Float64Array[] {
  const { samples } = cloth
  const footprints = ridges.map((ridge) => footprintOf(samples, ridge))
  const fades = ridges.map((ridge) => {
    const fade = fadeOf(ridge)
    return fade.map(
      (value, k) =>
        value * Math.max(0, cloth.shown[sampleAt(samples, ridge.points[2 * k], ridge.points[2 * k + 1])]),
    )
  })
  const smoothed = fieldSmoother(samples.grid, LOCAL * wavelength)
  const gain = ridges.map(({ heights }) => heights.map(() => 1))
  let heights: Float64Array[] = []
  for (let pass = 0; pass < PASSES; pass++) {
    const wanted = ridges.map(({ heights }, i) =>
      heights.map((height, k) => Math.min(limit, gain[i][k] * height) * fades[i][k]),
    )
    heights = wanted.map((own) => own.slice())
    for (let round = 0; round < ROUNDS; round++) {
      const drawn = draw(samples, footprints, heights)
      for (const [i, { points }] of ridges.entries()) {
        const factors = wanted[i].map((height, k) => {
          const own = interpolated(samples, drawn, points[2 * k], points[2 * k + 1])
          return own > 0.05 * limit ? clamp(height / own, 0.6, 1.4) : 1
        })
        const smooth = averaged(factors)
        for (let k = 0; k < smooth.length; k++)
          heights[i][k] = Math.min(wanted[i][k], heights[i][k] * smooth[k])
      }
    }
    const gains = lengthGains(cloth, draw(samples, footprints, heights), smoothed)
    for (const [i, { points }] of ridges.entries())
      for (let k = 0; k < gain[i].length; k++)
        gain[i][k] *= interpolated(samples, gains, points[2 * k], points[2 * k + 1])
  }
  return heights
}

/** Returns factors on the heights with which the folds around a sample take up the length that the cloth loses there. */
function lengthGains(
  { samples, wanted, across: [ax, ay] }: BuckledCloth,
  drawn: Float64Array,
  smoothed: (field: ArrayLike<number>) => Float64Array,
): Float64Array {
  const { width, height, spacing } = samples.grid
  const taken = new Float64Array(drawn.length)
  for (let y = 1; y < height - 1; y++) {
    for (let x = 1; x < width - 1; x++) {
      const i = y * width + x
      const slope =
        (ax[i] * (drawn[i + 1] - drawn[i - 1]) + ay[i] * (drawn[i + width] - drawn[i - width])) /
        (2 * spacing)
      taken[i] = Math.sqrt((1 - wanted[i]) ** 2 + slope * slope) - (1 - wanted[i])
    }
  }
  const [got, lost] = [smoothed(taken), smoothed(wanted)]
  return got.map((value, i) => {
    const gain = clamp(Math.sqrt(Math.max(0, lost[i]) / Math.max(value, 1e-4)), ...GAIN)
    return lerp(1, gain, smoothstep((lost[i] - COMPARED[0]) / (COMPARED[1] - COMPARED[0])))
  })
}

function footprintOf(samples: ChartSamples, { points, reach }: Ridge): Footprint {
  const { grid } = samples
  const { width, height, spacing } = grid
  const most = Math.max(...reach)
  const found = new Map<number, { square: number; point: number }>()
  for (let k = 0; k < points.length / 2; k++) {
    const [px, py] = [points[2 * k], points[2 * k + 1]]
    for (let y = Math.ceil((py - most) / spacing); y <= (py + most) / spacing; y++) {
      for (let x = Math.ceil((px - most) / spacing); x <= (px + most) / spacing; x++) {
        if (x < 0 || y < 0 || x >= width || y >= height) continue
        const square = (x * spacing - px) ** 2 + (y * spacing - py) ** 2
        const before = found.get(y * width + x)
        if (square <= most * most && (!before || square < before.square))
          found.set(y * width + x, { square, point: k })
      }
    }
  }
  const out: Footprint = { samples: [], factors: [], nearest: [] }
  for (const [sample, { square, point }] of found) {
    const [a, b] = [Math.max(0, point - 1), Math.min(points.length / 2 - 1, point + 1)]
    const [dx, dy] = [points[2 * b] - points[2 * a], points[2 * b + 1] - points[2 * a + 1]]
    const [ox, oy] = [
      (sample % width) * spacing - points[2 * point],
      Math.floor(sample / width) * spacing - points[2 * point + 1],
    ]
    const wall = dx * oy - dy * ox > 0 ? reach[0] : reach[1]
    out.samples.push(sample)
    out.factors.push(bulgeAt(Math.sqrt(square) / wall))
    out.nearest.push(point)
  }
  return out
}

function draw(
  samples: ChartSamples,
  footprints: readonly Footprint[],
  heights: readonly Float64Array[],
): Float64Array {
  const out = new Float64Array(samples.grid.width * samples.grid.height)
  for (const [i, { samples: own, factors, nearest }] of footprints.entries())
    for (let n = 0; n < own.length; n++) out[own[n]] += factors[n] * heights[i][nearest[n]]
  return out
}

/** Returns factors along a ridge that fade out at its free ends. */
function fadeOf({ points, reach, joins }: Ridge): Float64Array {
  const count = points.length / 2
  const along = new Float64Array(count)
  for (let k = 1; k < count; k++)
    along[k] =
      along[k - 1] + length2(points[2 * k] - points[2 * k - 2], points[2 * k + 1] - points[2 * k - 1])
  const total = along[count - 1]
  const fade = Math.min(0.5 * total, (FADE * (reach[0] + reach[1])) / 2)
  return along.map(
    (s) => (joins[0] ? 1 : smoothstep(s / fade)) * (joins[1] ? 1 : smoothstep((total - s) / fade)),
  )
}

/** Interpolates a field bilinearly at a position in millimetres from the first sample. */
function interpolated({ grid }: ChartSamples, field: Float64Array, x: number, y: number): number {
  const { width, height, spacing } = grid
  const [column, row] = [clamp(x / spacing, 0, width - 1.001), clamp(y / spacing, 0, height - 1.001)]
  const [left, top] = [Math.floor(column), Math.floor(row)]
  const i = top * width + left
  const [s, t] = [column - left, row - top]
  return (1 - t) * lerp(field[i], field[i + 1], s) + t * lerp(field[i + width], field[i + width + 1], s)
}

function averaged(values: Float64Array): Float64Array {
  return values.map((_, i) => {
    const [from, to] = [Math.max(0, i - WINDOW), Math.min(values.length, i + WINDOW + 1)]
    let sum = 0
    for (let k = from; k < to; k++) sum += values[k]
    return sum / (to - from)
  })
}
