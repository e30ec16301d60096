import { bezierAt } from '../../../math/bezier.ts'
import type { Rng } from '../../../math/rng.ts'
import { type ChartPoint, unroll } from '../surface/head-chart.ts'
import type { LandmarkPosition, Landmarks } from '../surface/landmarks.ts'

/** Cross-section of a line and its fading. */
export interface LineStyle {
  /** Full width of the valley in millimetres. */
  width: number
  /** Depth as a fraction of the region's deepest line, 0..1. */
  depth: number
  /** Fractions of the length over which the line fades in and out. */
  taper: readonly [start: number, end: number]
  /** Height of the raised banks, left and right along the line, 0..1. */
  shoulder: readonly [left: number, right: number]
  /** Asymmetry, -0.9..0.9: positive is steeper on the left of the line. */
  lean?: number
  /** Roundness of the valley's bottom, 0..1. */
  softness: number
  /** Whether the direction is random, so that compression across the line is not measured. */
  isDimple?: boolean
}

/** Part of the skin that creases as one area. */
export interface SkinRegion {
  /** Name of its area. */
  name: string
  /** Weights of the blendshapes that crease it most, by ARKit names or the skin's own. */
  cause: Readonly<Record<string, number>>
  /** ARKit names of the cause, if other shapes stand in for them. */
  shapes?: readonly string[]
  /** Width of skin in millimetres whose shortening one line takes up. */
  spacing: number
  /** Fraction of the compression that shows as creases; soft tissue takes the rest. */
  creasedFraction: number
  /** Maximum depth in millimetres. */
  maxDepth: number
  /** Fraction of the depth that remains at rest on a face of 70 years, 0..1. Lines of other skin vanish at rest. */
  atRest?: number
  /** Compression by muscles that pucker the skin, which targets do not show. If set, the cause alone drives the area. */
  assumedCompression?: number
  /** Distance by which its area extends beyond its lines, and distance over which the area then fades out, in millimetres. */
  reach: number
  feather: number
  /** Weight of the area at a point, 0..1, where neighbours share its lines. */
  influence?: (point: ChartPoint) => number
}

/** Anatomical path of a crease. */
export interface Guide extends LineStyle {
  path: readonly ChartPoint[]
  /**
   * Width of the skin that the line takes up, in millimetres to the left (+) or right (-) of its direction. Default: skin along the line.
   */
  gathers?: number
}

/** Part of a face. */
export interface FaceRegion extends SkinRegion {
  guides: readonly Guide[]
  /** Blendshapes that the lines are drawn for, if regions share lines; default: `cause`. */
  expression?: SkinRegion['cause']
}

export interface FaceContext {
  landmarks: Landmarks
  /** 0 at 20 years, 1 at 80. */
  ageFraction: number
  /** Interpolates between age 20 and age 80. */
  byAge(at20: number, at80: number): number
  /** Returns random numbers for one part of the face. */
  rngOf(name: string): Rng
}

/** 1 for the person's left, -1 for the right. */
export type Side = 1 | -1

/** Both sides, with the suffixes of ARKit names. */
export const SIDES = [
  [1, 'Left'],
  [-1, 'Right'],
] as const

/** Projects a landmark onto the head's chart. */
export function chartPointOf([x, y, z]: LandmarkPosition): ChartPoint {
  return unroll(x, y, z)
}

/** Samples a curve at even steps of its parameter, 0..1. */
export function sampleCurve(count: number, at: (t: number) => ChartPoint): ChartPoint[] {
  return Array.from({ length: count }, (_, i) => at(i / (count - 1)))
}

/** Samples a cubic Bezier curve, mirrored to a side. */
export function bezierPath(
  side: Side,
  a: ChartPoint,
  b: ChartPoint,
  c: ChartPoint,
  d: ChartPoint,
): ChartPoint[] {
  return sampleCurve(16, (t) => {
    const [across, up] = bezierAt(a, b, c, d, t)
    return [side * across, up]
  })
}
