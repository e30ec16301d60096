import { barycentricsAt, normalAt } from '../../skin/walk.ts'
import type { SkinLine } from '../../strokes/curve.ts'
import type { Stroke } from '../../strokes/document.ts'
import { depthFactor, type LaidStroke, layOutStroke, sectionOf } from '../../strokes/lay-out.ts'
import { bankSlope } from '../../strokes/profile.ts'
import type { LineStyle, SkinRegion } from '../anatomy/region.ts'
import { bankReaches } from './bank-reaches.ts'
import { creaseDepth } from './crease-depth.ts'
import { type DepthVariation, depthVariations } from './depth-variation.ts'
import { keptRuns, type LaidLine } from './laid-line.ts'
import type { Strengths } from './region-strengths.ts'
import { type StrokedSkin, strokeOf, uvAt } from './stroke-of.ts'

/** Lines of a region, in several forms. */
export interface RegionCreases {
  /** All lines except dimples, before conversion to strokes. */
  folds: readonly SkinLine[]
  /** All lines as strokes. */
  strokes: readonly Stroke[]
  /** The strokes, laid on the skin. */
  creases: readonly LaidStroke[]
  /** Fraction of length that the skin loses across the lines in the region's expression. Points with stretched skin are ignored. */
  compression: number
  /** Fraction of length that cloth loses, if folds take up only a part of it. */
  lost?: number
}

/** Region with its lines. Regions that share lines have the same arrays. */
export interface CreasedRegion extends RegionCreases {
  region: SkinRegion
}

export interface LineSettings {
  /** Age as a number from 0 (20 years) to 1 (80 years). */
  ageFraction: number
  /** Factor on the depth. */
  strength: number
  /** Factors on the depth in single regions. */
  strengths: Strengths
  seed: number
  /** Symmetry of the face's lines, 0..1; see `AutoOptions`. */
  symmetry: number
}

/** Fraction of the depth that remains where the expression does not compress the skin. */
const MIN_DEPTH = 0.3
/** Maximum random reduction of a line's depth, as a fraction. */
const VARIATION = 0.4
/**
 * Root mean square of the factor by which the random reduction multiplies a depth. Depths are divided by it, so that the reduction does not
 * change the total length that a valley takes up. This length grows with the square of the depth.
 */
const UNIFORM = 0.81
/** Maximum slope of a bank's outer side (10 degrees). Steeper banks would look like a white rim in the light. */
const MAX_BANK_SLOPE = 0.18
/** Compressions are averaged over this number of points on either side of a point. */
const AVERAGE_RADIUS = 6
/** The compression of a region is chosen so that this fraction of the compressed points on its lines exceeds it. */
const ABOVE = 0.3

/**
 * Converts the lines of a region to strokes. The strokes are deep enough to take up the length that the skin loses, and shallower where it
 * loses less.
 */
export function creaseLines(
  prepared: StrokedSkin,
  {
    name,
    spacing,
    creasedFraction,
    maxDepth,
    assumedCompression = 0,
  }: Pick<SkinRegion, 'name' | 'spacing' | 'creasedFraction' | 'maxDepth' | 'assumedCompression'>,
  lines: readonly LaidLine[],
  { strength, symmetry }: Pick<LineSettings, 'strength' | 'symmetry'>,
): RegionCreases {
  const measured = lines.flatMap(({ style, compressions }) =>
    style.isDimple ? [] : compressions.filter((value) => value > 0),
  )
  const compression = Math.max(assumedCompression, typicalCompression(measured))
  const variations = depthVariations(name, lines, symmetry)
  const drawn = lines.flatMap((line, i) =>
    clipToDrawn(line, prepared).map((part) => ({ ...part, variation: variations[i] })),
  )
  const onSkin = drawn.map((line) => foldOf(line, prepared))
  const folds = onSkin.filter((_, i) => !drawn[i].style.isDimple)
  const foldDepths = drawn.flatMap(({ style }) => (style.isDimple ? [] : style.depth))
  const reaches = bankReaches(folds, foldDepths, spacing)
  const banks = onSkin.map((line) => reaches[folds.indexOf(line)])
  const strokes = drawn.map((line, i): Stroke => {
    const { style } = line
    const factors = depthFactors(line, compression)
    const deepest = Math.max(...factors)
    const depthOf = (shoulder: LineStyle['shoulder']) => {
      const section = sectionOf({ ...style, shoulder, bank: banks[i] })
      const fullDepth = creaseDepth(creasedFraction * compression, spacing, style.width / 2, section)
      return strength * style.depth * Math.min(maxDepth, fullDepth / UNIFORM)
    }
    // The depth is computed again with the lower banks, because lower banks take up less length and the valley must take up more.
    const depth = depthOf(gentleBanks(style, deepest * depthOf(style.shoulder), banks[i]))
    const shoulder = gentleBanks(style, deepest * depth, banks[i])
    const gentle = { ...line, style: { ...style, shoulder } }
    return strokeOf(gentle, depth, factors, banks[i], prepared)
  })
  const creases = strokes.flatMap((stroke) => layOutStroke(stroke, prepared))
  return { folds, strokes, creases, compression }
}

/** Limits the heights of a line's banks so that their slopes are at most `MAX_BANK_SLOPE`. */
function gentleBanks(
  { width, shoulder: [left, right] }: LineStyle,
  depth: number,
  reaches: readonly [number, number] | undefined,
): LineStyle['shoulder'] {
  if (!reaches) return [left, right]
  const most = reaches.map((reach) => MAX_BANK_SLOPE / bankSlope(depth, width / 2, reach))
  return [Math.min(left, most[0]), Math.min(right, most[1])]
}

/**
 * Computes a factor on the depth for each point of a line. Without `relativeDepths`, the factors depend on random noise, and on the depths of the
 * style or the compression.
 */
function depthFactors(
  { style: { depths }, compressions, relativeDepths, variation }: LaidLine & { variation: DepthVariation },
  full: number,
): readonly number[] {
  if (relativeDepths) return relativeDepths
  return movingAverage(compressions).map((compression, i) => {
    const relative = full > 0 ? Math.min(1, Math.max(0, compression) / full) : 0
    const factor = depths
      ? depthFactor(depths, i / (compressions.length - 1))
      : MIN_DEPTH + (1 - MIN_DEPTH) * Math.sqrt(relative)
    const shallower = VARIATION * (0.5 + 0.5 * variation(i))
    return factor * (1 - shallower)
  })
}

/** Adds the normals of the skin to a line. */
export function foldOf({ points, triangles }: LaidLine, { surface }: StrokedSkin): SkinLine {
  const normals = new Float64Array(points.length)
  const [weights, normal] = [new Float64Array(3), new Float64Array(3)]
  for (const [i, triangle] of triangles.entries()) {
    barycentricsAt(weights, surface, triangle, points.subarray(3 * i, 3 * i + 3))
    normalAt(normal, surface, triangle, weights)
    normals.set(normal, 3 * i)
  }
  return { points, normals }
}

/** Returns the parts of a line that are inside the texture and on drawn triangles. Parts do not fade where the line is cut. */
export function clipToDrawn(line: LaidLine, skin: StrokedSkin): LaidLine[] {
  const { points, triangles, compressions, relativeDepths, style } = line
  const isDrawn = (i: number) =>
    skin.isDrawn(triangles[i]) && uvAt(line, i, skin).every((value) => value >= 0 && value <= 1)
  return keptRuns(triangles.length, isDrawn).map(([start, end]) => {
    const taper = [start === 0 ? style.taper[0] : 0, end === triangles.length ? style.taper[1] : 0] as const
    return {
      style: { ...style, taper },
      points: points.slice(3 * start, 3 * end),
      triangles: triangles.slice(start, end),
      compressions: compressions.slice(start, end),
      ...(relativeDepths && { relativeDepths: relativeDepths.slice(start, end) }),
    }
  })
}

/** Averages values over a few millimetres, so that a line's depth does not jump from triangle to triangle. */
function movingAverage(values: readonly number[]): number[] {
  return values.map((_, i) => {
    const window = values.slice(Math.max(0, i - AVERAGE_RADIUS), i + AVERAGE_RADIUS + 1)
    return window.reduce((a, b) => a + b, 0) / window.length
  })
}

/** Returns the compression of a region: the value that the fraction `ABOVE` of the compressions on its lines exceeds. */
export function typicalCompression(compressions: readonly number[]): number {
  const sorted = [...compressions].sort((a, b) => b - a)
  return sorted[Math.floor(ABOVE * sorted.length)] ?? 0
}
