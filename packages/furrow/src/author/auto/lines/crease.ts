import { noise } from '../../../math/noise.ts'
import { Rng } from '../../../math/rng.ts'
import { barycentricsAt, normalAt } from '../../skin/walk.ts'
import type { SkinLine } from '../../strokes/curve.ts'
import type { Stroke } from '../../strokes/document.ts'
import { type LaidStroke, layOutStroke, sectionOf } from '../../strokes/lay-out.ts'
import { bankSlope } from '../../strokes/profile.ts'
import type { LineStyle, SkinRegion } from '../anatomy/region.ts'
import { bankReaches } from './bank-reaches.ts'
import { creaseDepth } from './crease-depth.ts'
import { type LaidLine, MIN_POINTS } from './laid-line.ts'
import { type StrokedSkin, strokeOf, uvAt } from './stroke-of.ts'
import { STEP } from './trace.ts'

/** Creases of a region. */
export interface RegionCreases {
  /** Fold lines: all lines except dimples. Strokes follow them within a tolerance. */
  folds: readonly SkinLine[]
  strokes: readonly Stroke[]
  /** Strokes laid on the skin. */
  creases: readonly LaidStroke[]
  /** Fraction by which the expression shortens the skin across the lines, where it does. */
  compression: number
}

/** Region with its lines laid on the skin. Regions that share lines share one array of creases. */
export interface CreasedRegion extends RegionCreases {
  region: SkinRegion
}

export interface LineSettings {
  /** 0 at 20 years, 1 at 80. */
  ageFraction: number
  /** Factor on the depth. */
  strength: number
  seed: number
}

/** Fraction of the depth that remains where the expression does not compress the skin. */
const MIN_DEPTH = 0.3
/**
 * Maximum random reduction of a line's depth as a fraction, and its approximate wavelength in millimetres.
 * The skin taken up grows with the square of the depth. UNIFORM is the root mean square of the reduced depth along a line.
 */
const VARIATION = 0.4
const WAVELENGTH = 8
const UNIFORM = 0.81
/** Maximum slope of a bank's outer side (10 degrees): steeper ones catch the light as a white rim. */
const MAX_BANK_SLOPE = 0.18
/** Number of points to either side over which a line's compression is averaged. */
const AVERAGE_RADIUS = 6
/** Fraction of all line points that may exceed the region's compression. */
const ABOVE = 0.3

/**
 * Converts lines to strokes deep enough to take up the length that the skin loses, and shallower where it loses less.
 *
 * @param strength factor on the depth.
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
  strength: number,
): RegionCreases {
  const measured = lines
    .flatMap(({ style, compressions }) => (style.isDimple ? [] : compressions.filter((value) => value > 0)))
    .sort((a, b) => b - a)
  const compression = Math.max(assumedCompression, measured[Math.floor(ABOVE * measured.length)] ?? 0)
  const rng = new Rng(0, `${name} depth`)
  const drawn = lines.flatMap((line) => {
    const variation = Math.floor(2 ** 31 * rng.next())
    return clipToDrawn(line, prepared).map((part) => ({ ...part, variation }))
  })
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
    // Lower banks let the valley take up more.
    const depth = depthOf(gentleBanks(style, deepest * depthOf(style.shoulder), banks[i]))
    const shoulder = gentleBanks(style, deepest * depth, banks[i])
    const gentle = { ...line, style: { ...style, shoulder } }
    return strokeOf(gentle, depth, factors, banks[i], prepared)
  })
  const creases = strokes.flatMap((stroke) => layOutStroke(stroke, prepared))
  return { folds, strokes, creases, compression }
}

/** Limits the heights of a line's banks so that none is steeper than MAX_BANK_SLOPE. */
function gentleBanks(
  { width, shoulder: [left, right] }: LineStyle,
  depth: number,
  reaches: readonly [number, number] | undefined,
): LineStyle['shoulder'] {
  if (!reaches) return [left, right]
  const most = reaches.map((reach) => MAX_BANK_SLOPE / bankSlope(depth, width / 2, reach))
  return [Math.min(left, most[0]), Math.min(right, most[1])]
}

/** Computes factors on a line's depth from the local compression and noise. */
function depthFactors({ compressions, variation }: LaidLine & { variation: number }, full: number): number[] {
  return movingAverage(compressions).map((compression, i) => {
    const relative = full > 0 ? Math.min(1, Math.max(0, compression) / full) : 0
    const shallower = VARIATION * (0.5 + 0.5 * noise((i * STEP) / WAVELENGTH, variation))
    return (MIN_DEPTH + (1 - MIN_DEPTH) * Math.sqrt(relative)) * (1 - shallower)
  })
}

/** Returns a line with the skin's normals. */
function foldOf({ points, triangles }: LaidLine, { surface }: StrokedSkin): SkinLine {
  const normals = new Float64Array(points.length)
  const [weights, normal] = [new Float64Array(3), new Float64Array(3)]
  for (const [i, triangle] of triangles.entries()) {
    barycentricsAt(weights, surface, triangle, points.subarray(3 * i, 3 * i + 3))
    normalAt(normal, surface, triangle, weights)
    normals.set(normal, 3 * i)
  }
  return { points, normals }
}

/** Returns the parts of a line inside the texture and on drawn triangles, without fading at cuts. */
function clipToDrawn(line: LaidLine, skin: StrokedSkin): LaidLine[] {
  const { points, triangles, compressions, style } = line
  const isDrawn = (i: number) =>
    skin.isDrawn(triangles[i]) && uvAt(line, i, skin).every((value) => value >= 0 && value <= 1)
  const parts: LaidLine[] = []
  for (let start = 0; start < triangles.length; ) {
    let end = start
    while (end < triangles.length && isDrawn(end)) end++
    if (end - start >= MIN_POINTS) {
      const taper = [start === 0 ? style.taper[0] : 0, end === triangles.length ? style.taper[1] : 0] as const
      parts.push({
        style: { ...style, taper },
        points: points.slice(3 * start, 3 * end),
        triangles: triangles.slice(start, end),
        compressions: compressions.slice(start, end),
      })
    }
    start = end + 1
  }
  return parts
}

/** Averages over a few millimetres, so that a line's depth does not jump between triangles. */
function movingAverage(values: readonly number[]): number[] {
  return values.map((_, i) => {
    const window = values.slice(Math.max(0, i - AVERAGE_RADIUS), i + AVERAGE_RADIUS + 1)
    return window.reduce((a, b) => a + b, 0) / window.length
  })
}
