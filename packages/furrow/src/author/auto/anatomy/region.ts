import { bezierAt } from '../../../math/bezier.ts'
import { atan2 } from '../../../math/elementary.ts'
import { smoothstep } from '../../../math/scalar.ts'
import { unit2 } from '../../../math/vector.ts'
import type { FilmNoise } from '../buckling/film-noise.ts'
import { type ChartPoint, unroll } from '../surface/head-chart.ts'
import type { LandmarkPosition, Landmarks } from '../surface/landmarks.ts'
import type { FaceRng } from './face-rng.ts'
import type { DenseRegion } from './region-names.ts'

/** Cross-section of a wrinkle line, and how the line fades at its ends. */
export interface LineStyle {
  /** Width of the valley in millimetres. */
  width: number
  /** Depth relative to the depth of the region's deepest line, 0..1. */
  depth: number
  /**
   * Depths along the line relative to its deepest point, 0..1, at even distances. Default: the depth follows the compression of the skin.
   */
  depths?: readonly number[]
  /** Lengths of the fade-in at the start and the fade-out at the end, as fractions of the line's length. */
  taper: readonly [start: number, end: number]
  /** Strengths of the raised banks on the left and right of the line, 0..1. */
  shoulder: readonly [left: number, right: number]
  /** Asymmetry of the valley, -0.9..0.9. Positive values make the left side steeper. */
  lean?: number
  /** Roundness of the valley's bottom, 0..1. */
  softness: number
  /** Whether the line is a dimple. Compression is not measured across dimples, because their directions are random. */
  isDimple?: boolean
}

/** Part of the face's skin that has its own area of influence. */
export interface SkinRegion {
  /** Name of the area. */
  name: string
  /** Weights of the blendshapes that crease the region most. The keys are ARKit names, or the rig's own names. */
  cause: Readonly<Record<string, number>>
  /** ARKit names in the original `cause`, whose names may have been replaced by the rig's own names. For messages. */
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
   * Minimum compression for the depth of the lines, for regions whose blendshapes compress the skin less than the muscle does. If set, the
   * driver is not fitted to the measured compression, but has the weights of `cause`.
   */
  assumedCompression?: number
  /** Distance from the lines, in millimetres, at which the area starts to fade out. */
  reach: number
  /** Distance over which the area fades out, in millimetres. */
  feather: number
  /** Returns a factor on the area's weight at a point, 0..1. With it, several areas can each show a different part of the same lines. */
  influence?: (point: ChartPoint) => number
  /** Whether the chart of the head does not apply to the region, for example on hands. */
  isOffHead?: boolean
}

/** Typical path of a crease on the face, known from anatomy. */
export interface Guide extends LineStyle {
  path: readonly ChartPoint[]
}

/** Skin that buckles under compression, see `buckle`. */
export interface SkinFilm {
  /** Origin of the skin's random variation, on the head's chart. Lines start at the end that is nearer to it. */
  centre: ChartPoint
  /**
   * Returns whether a point is inside the flattened patch. This patch of skin is flattened to a plane, in which the folds are computed. It
   * consists of the compressed skin and a margin around it.
   */
  isFlattened(point: ChartPoint): boolean
  /** Returns the weight of the compression at a point, 0..1. It falls to 0 where the muscle ends. */
  weight(point: ChartPoint): number
  /** Returns the thickness of the dermis at a point, in millimetres. */
  thickness(point: ChartPoint): number
  /** Factor on the number of folds. */
  density: number
  /** Returns the unit direction of the muscle's pull at a point, on the head's chart. */
  pull(point: ChartPoint): ChartPoint
  /**
   * Fraction of the compression along the pull that is the same on the whole patch, 0..1; default: 0. A broad muscle shortens its skin evenly,
   * but blendshapes often leave parts of it behind.
   */
  evenness?: number
  /**
   * Random variation of the skin: standard deviations of the relative thickness and of the logarithm of the critical compression, and size of
   * the irregularities in millimetres (see `planeNoise`).
   */
  variation: { thickness: number; critical: number; size: number }
  /** Irregularities of the skin, mirrored from side to side on a symmetric face. */
  noise: FilmNoise
  /** Style of the deepest line. */
  style: LineStyle
}

/** Region of a face whose lines follow anatomical paths. */
export interface GuidedRegion extends SkinRegion {
  guides: readonly Guide[]
  /** Blendshape weights of the pose in which the lines are computed. Needed if several regions share lines. Default: `cause`. */
  expression?: SkinRegion['cause']
}

/** Region of a face whose lines emerge from compressed skin. */
export interface BucklingRegion extends SkinRegion {
  film: SkinFilm
  expression?: SkinRegion['cause']
}

/** Region of a face. */
export type FaceRegion = GuidedRegion | BucklingRegion

/** Opening of the eye at rest, on the head's chart, mirrored to the person's left. */
export interface EyeOpening {
  inner: ChartPoint
  outer: ChartPoint
  /** Height of the lowest point of the lower lid's margin. */
  lowest: number
}

/** Input for creating the regions of a face. */
export interface FaceContext {
  landmarks: Landmarks
  /** Age as a number from 0 (20 years) to 1 (80 years). */
  ageFraction: number
  /** Interpolates linearly between a value at 20 years and a value at 80 years. */
  byAge(at20: number, at80: number): number
  /** Returns the distance of the outermost skin from the head's axis in millimetres; undefined without skin. */
  radiusAt(point: ChartPoint): number | undefined
  /** Returns where an expression, given by ARKit names, moves the skin at a point: its position in face coordinates; undefined without skin. */
  posedBy(
    expression: Readonly<Record<string, number>>,
  ): (point: ChartPoint) => [x: number, y: number, z: number] | undefined
  /** Returns where an expression, given by ARKit names, moves the skin around a point. Points without skin stay where they are. */
  motionOf(expression: Readonly<Record<string, number>>): (point: ChartPoint) => ChartPoint
  /** Returns the opening of an eye (see `eyeOpening`), which is computed once. */
  openingOf(side: Side): EyeOpening
  /** Returns the factor on the number of lines of a region; see `AutoOptions`. */
  densityOf(region: DenseRegion): number
  /** Returns a random number generator for one part of the face; see `FaceRng.of`. */
  rngOf(name: string): FaceRng
}

/** Side of the face: 1 for the person's left, -1 for the person's right. */
export type Side = 1 | -1

/** Both sides, with their suffixes in ARKit names. */
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

/** Returns a smooth step from 0 at `from` to 1 at `to`, which may be smaller than `from`. */
export function fade(value: number, from: number, to: number): number {
  return smoothstep((value - from) / (to - from))
}

/** Returns a direction in degrees above the horizontal. */
export function degreesOf(across: number, up: number): number {
  return (atan2(up, across) * 180) / Math.PI
}

/**
 * Returns the pull of a muscle that surrounds a point, for `SkinFilm.pull`. If `flattening` is 1, the folds lie on lines through the point.
 *
 * @param flattening factor on the slope of the folds.
 */
export function pullAround([x, y]: ChartPoint, flattening = 1): SkinFilm['pull'] {
  return ([across, up]) => {
    const [dx, dy] = unit2(across - x, flattening * (up - y))
    return [-dy, dx]
  }
}
