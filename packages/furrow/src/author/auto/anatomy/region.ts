import { bezierAt } from '../../../math/bezier.ts'
import type { Rng } from '../../../math/rng.ts'
import { type ChartPoint, unroll } from '../surface/head-chart.ts'
import type { LandmarkPosition, Landmarks } from '../surface/landmarks.ts'

/** Cross-section of a wrinkle line, and how the line fades at its ends. */
export interface LineStyle {
  /** Width of the valley in millimetres. */
  width: number
  /** Depth relative to the depth of the region's deepest line, 0..1. */
  depth: number
  /** Fractions of the length over which the line fades in and out. */
  taper: readonly [start: number, end: number]
  /** Strengths of the raised banks on the left and right of the line, 0..1. */
  shoulder: readonly [left: number, right: number]
  /** Asymmetry of the valley, -0.9..0.9. Positive values make the left side steeper. */
  lean?: number
  /** Roundness of the valley's bottom, 0..1. */
  softness: number
  /** Whether the line is a dimple. Dimples have random directions, so the compression across them means nothing and is not measured. */
  isDimple?: boolean
}

/** Part of the skin that creases together and gets one area of influence. */
export interface SkinRegion {
  /** Name of the area. */
  name: string
  /** Weights of the blendshapes that crease the region most, by ARKit names or by names of the rig. */
  cause: Readonly<Record<string, number>>
  /** ARKit names of the original cause, if `cause` has blendshapes of the rig that replace missing ARKit shapes. */
  shapes?: readonly string[]
  /** Distance between lines in millimetres. One line takes up the compression of the skin over this distance. */
  spacing: number
  /** Fraction of the compression that becomes creases. Soft tissue takes up the rest. */
  creasedFraction: number
  /** Maximum depth of a line in millimetres. */
  maxDepth: number
  /** Fraction of the depth that remains at rest on a face of 70 years, 0..1. If missing, the lines vanish at rest at any age. */
  atRest?: number
  /**
   * Compression of skin by muscles that pucker it, if blendshapes do not show this compression. If set, it replaces the measured compression,
   * and `cause` alone drives the area.
   */
  assumedCompression?: number
  /** Distance from the lines, in millimetres, at which the area starts to fade out. */
  reach: number
  /** Distance over which the area fades out, in millimetres. */
  feather: number
  /** Returns a factor on the area's weight at a point, 0..1. Several areas that show parts of the same lines have such a factor. */
  influence?: (point: ChartPoint) => number
}

/** Typical path of a crease on the face, known from anatomy. */
export interface Guide extends LineStyle {
  path: readonly ChartPoint[]
  /**
   * Width of skin in millimetres whose compression the line takes up. Positive: skin on the left of the line; negative: skin on the right.
   * Default: the compression is measured on the line.
   */
  gathers?: number
}

/** Region of a face, with the paths of its lines. */
export interface FaceRegion extends SkinRegion {
  guides: readonly Guide[]
  /** Weights of the blendshapes in whose pose the lines are computed, if several regions share lines. Default: `cause`. */
  expression?: SkinRegion['cause']
}

/** Data about a face from which its regions are created. */
export interface FaceContext {
  landmarks: Landmarks
  /** Age as a number from 0 (20 years) to 1 (80 years). */
  ageFraction: number
  /** Interpolates linearly between a value at 20 years and a value at 80 years. */
  byAge(at20: number, at80: number): number
  /** Returns a random number generator for one part of the face. */
  rngOf(name: string): Rng
}

/** Side of the face: 1 for the person's left, -1 for the person's right. */
export type Side = 1 | -1

/** Both sides, with the suffixes that ARKit names have. */
export const SIDES = [
  [1, 'Left'],
  [-1, 'Right'],
] as const

/** Projects a landmark onto the chart of the head (see `head-chart.ts`). */
export function chartPointOf([x, y, z]: LandmarkPosition): ChartPoint {
  return unroll(x, y, z)
}

/** Samples a curve at even steps of its parameter, 0..1. */
export function sampleCurve(count: number, at: (t: number) => ChartPoint): ChartPoint[] {
  return Array.from({ length: count }, (_, i) => at(i / (count - 1)))
}

/** Samples a cubic Bezier curve. Points are given for the left side of the face, and mirrored if `side` is -1. */
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
