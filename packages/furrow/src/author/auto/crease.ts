import { smoothstep } from '../../math/scalar.ts'
import { profile, REACH } from '../strokes/profile.ts'
import type { Spot } from './chart.ts'

/** How a line looks. */
export interface LineStyle {
  /** Full width of the valley in millimetres. */
  width: number
  /** Depth as a share of that of the region's deepest line, 0..1. */
  depth: number
  /** Shares of the length over which it fades in and out. */
  taper: readonly [start: number, end: number]
  /** Raised sides, left and right of its way, 0..1. */
  shoulder: readonly [left: number, right: number]
  /** Roundness of the valley's bottom, 0..1. */
  softness: number
  /** Whether it runs as it likes, so that nothing is measured across it. */
  isDimple?: boolean
}

/** A line on the skin. */
export interface LaidLine {
  style: LineStyle
  /** x, y and z of each point, and the skin's normal there, in millimetres. */
  points: Float64Array
  normals: Float64Array
  /** Share of its length that the skin loses across the line at each point; below 0 where it is stretched. */
  lost: readonly number[]
}

/** A part of the skin and how it creases. */
export interface SkinRegion {
  /** Name of its area. */
  name: string
  /** Blendshapes that crease it most, with weights, by ARKit's names or those of the skin. */
  cause: Readonly<Record<string, number>>
  /** Millimetres of skin whose shortening one line takes up. */
  spacing: number
  /** Share of the compression that shows as creases; soft tissue takes the rest. */
  hidden: number
  /** Greatest depth in millimetres that is believed. */
  deepest: number
  /** Compression of muscles that pucker skin within itself, which no target shows: what drives the area is its cause alone. */
  assumed?: number
  /** How far its area reaches beyond its lines, in millimetres, and over how many it fades. */
  reach: number
  feather: number
  /** Weight of the area at a spot, where it shares its lines with a neighbour. */
  share?: (spot: Spot) => number
}

/** A line on the skin with the relief it has there. */
export interface Crease {
  points: Float64Array
  normals: Float64Array
  /** Depth and half the width of the valley at each point, in millimetres. */
  depths: Float64Array
  halfWidths: Float64Array
  /** Raised sides, left and right of its way, seen from outside; 0..1. */
  shoulder: readonly [number, number]
  softness: number
  isDimple: boolean
}

/** A region whose lines lie on the skin. Regions that share their lines have the same list. */
export interface CreasedRegion {
  region: SkinRegion
  creases: readonly Crease[]
  /** Share by which the expression shortens the skin across the lines, where it does. */
  compression: number
}

/** Depth that is left where the expression does not push the skin together, as a share. */
const SLACK = 0.3
/** Points to either side over which a line's depth is evened. */
const EVEN = 6
/** Exponent that keeps a line's ends from fading too early. */
const BLUNT = 0.7
/** Width that is left where a line fades out. */
const END_WIDTH = 0.45
/** Of the points of all lines, the share that may be shortened more than what counts as the region's compression. */
const ABOVE = 0.3

/**
 * Gives lines their relief: deep enough to take up what the skin loses, and shallower where it loses less.
 *
 * @param strength multiplies the depth.
 */
export function creaseLines(
  { spacing, hidden, deepest, assumed = 0 }: Pick<SkinRegion, 'spacing' | 'hidden' | 'deepest' | 'assumed'>,
  lines: readonly LaidLine[],
  strength: number,
): Omit<CreasedRegion, 'region'> {
  const pushed = lines
    .flatMap(({ style, lost }) => (style.isDimple ? [] : lost.filter((share) => share > 0)))
    .sort((a, b) => b - a)
  const compression = Math.max(assumed, pushed[Math.floor(ABOVE * pushed.length)] ?? 0)
  const creases = lines.map(({ style, points, normals, lost }): Crease => {
    const { width, shoulder, softness, taper } = style
    const full = creaseDepth(hidden * compression, spacing, width / 2, shoulder, softness)
    const most = strength * style.depth * Math.min(deepest, full)
    const evened = evenOut(lost)
    const fades = lost.map((_, i) => fadeAt(i / Math.max(1, lost.length - 1), taper))
    const shares = evened.map((share) =>
      compression > 0 ? Math.min(1, Math.max(0, share) / compression) : 0,
    )
    return {
      points,
      normals,
      depths: Float64Array.from(
        fades,
        (fade, i) => most * fade * (SLACK + (1 - SLACK) * Math.sqrt(shares[i]!)),
      ),
      halfWidths: Float64Array.from(fades, (fade) => (width / 2) * (END_WIDTH + (1 - END_WIDTH) * fade)),
      shoulder,
      softness,
      isDimple: style.isDimple ?? false,
    }
  })
  return { creases, compression }
}

function fadeAt(share: number, [start, end]: readonly [number, number]): number {
  const head = start > 0 ? smoothstep(share / start) : 1
  const tail = end > 0 ? smoothstep((1 - share) / end) : 1
  return (head * tail) ** BLUNT
}

/**
 * Depth of a valley that takes up what skin loses: of rest lengths dx across it (1 - e) dx is left, over which the relief must be dx long,
 * so the mean of sqrt((1 - e)^2 + h'^2) over one spacing is 1.
 *
 * @param compression e, 0..1.
 * @param spacing from line to line, and half the width of a valley, in millimetres.
 */
export function creaseDepth(
  compression: number,
  spacing: number,
  halfWidth: number,
  shoulder: readonly [number, number],
  softness: number,
): number {
  const left = 1 - Math.min(Math.max(compression, 0), 1)
  const end = Math.min(REACH, spacing / (2 * halfWidth))
  const steps = Math.ceil(end / FINE)
  const slopes = shoulder.flatMap((raised) =>
    Array.from({ length: steps }, (_, i) => {
      const [from, to] = [(end * i) / steps, (end * (i + 1)) / steps]
      return (profile(to, raised, softness) - profile(from, raised, softness)) / ((to - from) * halfWidth)
    }),
  )
  // Beyond the valley's reach the skin is flat and shortened all the same.
  const covered = (2 * end * halfWidth) / spacing
  const length = (depth: number) =>
    (covered * slopes.reduce((sum, slope) => sum + Math.hypot(left, depth * slope), 0)) / slopes.length +
    (1 - covered) * left
  let [low, high] = [0, 2 * spacing]
  for (let i = 0; i < HALVINGS; i++) {
    const middle = (low + high) / 2
    if (length(middle) < 1) low = middle
    else high = middle
  }
  return low
}

/** Step along a valley's side, in half widths, and halvings of the range of depths: to a thousandth of a millimetre. */
const FINE = 0.02
const HALVINGS = 16

/** Means over a few millimetres: a line does not change its depth at each triangle. */
function evenOut(values: readonly number[]): number[] {
  return values.map((_, i) => {
    const near = values.slice(Math.max(0, i - EVEN), i + EVEN + 1)
    return near.reduce((a, b) => a + b, 0) / near.length
  })
}
