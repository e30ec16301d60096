import { smoothstep } from '../../../math/scalar.ts'
import type { LineStyle, SkinRegion } from '../anatomy/region.ts'
import { creaseDepth } from './crease-depth.ts'

/** A line on the skin. */
export interface LaidLine {
  style: LineStyle
  /** x, y and z of each point and of the skin's normal there, in millimetres. */
  points: Float64Array
  normals: Float64Array
  /** Fraction of its length that the skin loses across the line at each point; below 0 where it is stretched. */
  compressions: readonly number[]
}

/** A line on the skin with its relief. */
export interface Crease {
  points: Float64Array
  normals: Float64Array
  /** Depth and half the width of the valley at each point, in millimetres. */
  depths: Float64Array
  halfWidths: Float64Array
  /** Height of the raised banks, left and right of its direction as seen from outside, 0..1. */
  shoulder: readonly [left: number, right: number]
  softness: number
  isDimple: boolean
}

/** The creases of a region. */
export interface RegionCreases {
  creases: readonly Crease[]
  /** Fraction by which the expression shortens the skin across the lines, where it does. */
  compression: number
}

/** A region whose lines are laid on the skin. Regions that share their lines have the same array of creases. */
export interface CreasedRegion extends RegionCreases {
  region: SkinRegion
}

/** How lines are laid. */
export interface LineSettings {
  /** 0 at 20 years, 1 at 80. */
  ageFraction: number
  /** Multiplies the depth. */
  strength: number
  seed: number
}

/** Fraction of the depth that is left where the expression does not compress the skin. */
const MIN_DEPTH = 0.3
/** Points to either side over which a line's compression is averaged. */
const AVERAGED = 6
/** Exponent that keeps a line's ends from fading too early. */
const BLUNT = 0.7
/** Fraction of the width that is left where a line fades out. */
const END_WIDTH = 0.45
/** Fraction of the points of all lines that may be compressed more than the region's compression. */
const ABOVE = 0.3

/**
 * Gives lines their relief: deep enough to take up the length that the skin loses, and shallower where it loses less.
 *
 * @param strength multiplies the depth.
 */
export function creaseLines(
  {
    spacing,
    creasedFraction,
    maxDepth,
    assumedCompression = 0,
  }: Pick<SkinRegion, 'spacing' | 'creasedFraction' | 'maxDepth' | 'assumedCompression'>,
  lines: readonly LaidLine[],
  strength: number,
): RegionCreases {
  const measured = lines
    .flatMap(({ style, compressions }) => (style.isDimple ? [] : compressions.filter((value) => value > 0)))
    .sort((a, b) => b - a)
  const compression = Math.max(assumedCompression, measured[Math.floor(ABOVE * measured.length)] ?? 0)
  const creases = lines.map(({ style, points, normals, compressions }): Crease => {
    const { width, shoulder, softness, taper } = style
    const fullDepth = creaseDepth(creasedFraction * compression, spacing, width / 2, shoulder, softness)
    const depth = strength * style.depth * Math.min(maxDepth, fullDepth)
    const fades = compressions.map((_, i) => fadeAt(i / Math.max(1, compressions.length - 1), taper))
    const relative = movingAverage(compressions).map((value) =>
      compression > 0 ? Math.min(1, Math.max(0, value) / compression) : 0,
    )
    return {
      points,
      normals,
      depths: Float64Array.from(
        fades,
        (fade, i) => depth * fade * (MIN_DEPTH + (1 - MIN_DEPTH) * Math.sqrt(relative[i])),
      ),
      halfWidths: Float64Array.from(fades, (fade) => (width / 2) * (END_WIDTH + (1 - END_WIDTH) * fade)),
      shoulder,
      softness,
      isDimple: style.isDimple ?? false,
    }
  })
  return { creases, compression }
}

/** How much of a line is left at t of its length, 0..1. */
function fadeAt(t: number, [start, end]: readonly [number, number]): number {
  const head = start > 0 ? smoothstep(t / start) : 1
  const tail = end > 0 ? smoothstep((1 - t) / end) : 1
  return (head * tail) ** BLUNT
}

/** Over a few millimetres: a line does not change its depth from triangle to triangle. */
function movingAverage(values: readonly number[]): number[] {
  return values.map((_, i) => {
    const window = values.slice(Math.max(0, i - AVERAGED), i + AVERAGED + 1)
    return window.reduce((a, b) => a + b, 0) / window.length
  })
}
