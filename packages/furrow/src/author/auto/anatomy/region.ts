import { bezierAt } from '../../../math/bezier.ts'
import type { Rng } from '../../../math/rng.ts'
import { type ChartPoint, unroll } from '../surface/head-chart.ts'
import type { LandmarkPosition, Landmarks } from '../surface/landmarks.ts'

/** How a line looks. */
export interface LineStyle {
  /** Full width of the valley in millimetres. */
  width: number
  /** Depth as a fraction of that of the region's deepest line, 0..1. */
  depth: number
  /** Fractions of the length over which it fades in and out. */
  taper: readonly [start: number, end: number]
  /** Height of the raised banks, left and right of its direction, 0..1. */
  shoulder: readonly [left: number, right: number]
  /** Steeper on the left of its direction than on the right, -0.9..0.9. */
  lean?: number
  /** Roundness of the valley's bottom, 0..1. */
  softness: number
  /** Whether its direction is random, so that no compression is measured across it. */
  isDimple?: boolean
}

/** A part of the skin and how it creases. */
export interface SkinRegion {
  /** Name of its area. */
  name: string
  /** Weights of the blendshapes that crease it most, by ARKit's names or those of the skin. */
  cause: Readonly<Record<string, number>>
  /** ARKit's names of its cause, where others stand in for them. */
  shapes?: readonly string[]
  /** Millimetres of skin whose shortening one line takes up. */
  spacing: number
  /** Fraction of the compression that shows as creases; soft tissue takes the rest. */
  creasedFraction: number
  /** In millimetres. */
  maxDepth: number
  /** Fraction of the depth that a face of 70 years has at rest, 0..1; lines of other skin go with what folds it. */
  atRest?: number
  /** Compression by muscles that pucker skin within itself, which no target shows: the area is driven by its cause alone. */
  assumedCompression?: number
  /** How far its area reaches beyond its lines, and over what distance it fades out from there, in millimetres. */
  reach: number
  feather: number
  /** Weight of the area at a point, 0..1, where neighbours share its lines. */
  influence?: (point: ChartPoint) => number
}

/** Where a crease would run by anatomy alone. */
export interface Guide extends LineStyle {
  path: readonly ChartPoint[]
  /** How far the skin reaches that it takes up, in millimetres to the left (+) or right (-) of its direction; by default it is that along the line. */
  gathers?: number
}

/** A part of a face. */
export interface FaceRegion extends SkinRegion {
  guides: readonly Guide[]
  /** Blendshapes that the lines are drawn for, where regions share them; its cause by default. */
  expression?: SkinRegion['cause']
}

/** What regions are made from. */
export interface FaceContext {
  landmarks: Landmarks
  /** 0 at 20 years, 1 at 80. */
  ageFraction: number
  /** Interpolates between age 20 and age 80. */
  byAge(at20: number, at80: number): number
  /** Random numbers for one part of the face. */
  rngOf(name: string): Rng
}

/** 1 for the person's left, -1 for the right. */
export type Side = 1 | -1

/** Both sides, with the endings of ARKit's names. */
export const SIDES = [
  [1, 'Left'],
  [-1, 'Right'],
] as const

/** A landmark on the chart of the head. */
export function chartPointOf([x, y, z]: LandmarkPosition): ChartPoint {
  return unroll(x, y, z)
}

/** Points of a curve, evenly spaced in its parameter 0..1. */
export function sampleCurve(count: number, at: (t: number) => ChartPoint): ChartPoint[] {
  return Array.from({ length: count }, (_, i) => at(i / (count - 1)))
}

/** A cubic Bezier curve, mirrored to the side. */
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
