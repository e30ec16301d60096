import { FurrowError } from '../../core/error.ts'
import type { Uv } from '../../core/json.ts'
import { noise } from '../../math/noise.ts'
import { clamp, lerp, smoothstep } from '../../math/scalar.ts'
import { cross, length3, normalize } from '../../math/vector.ts'
import { type LocatedSkin, layCurve, type SkinLine } from './curve.ts'
import type { Stroke } from './document.ts'
import { VALLEY_REACH } from './profile.ts'

/** Fields of a stroke that shape its cross-section. */
export type SectionStyle = Readonly<
  Pick<Stroke, 'width' | 'softness'> & {
    shoulder: CrossSection['shoulder']
    bank?: CrossSection['banks'] | undefined
    lean?: number | undefined
  }
>

/** Shape of a stroke's cross-section: a valley with a raised bank on each side. `LaidStroke` adds its size. */
export interface CrossSection {
  /** Strengths of the raised banks, 0..1; see `Stroke.shoulder`. */
  shoulder: readonly [left: number, right: number]
  /** Distances from the centre line to the outer ends of the banks, in half widths. */
  banks: readonly [left: number, right: number]
  lean: number
  softness: number
}

/** Uninterrupted part of a stroke as a line on the skin, with the size of its valley at each point. */
export interface LaidStroke extends SkinLine, CrossSection {
  /** Depth (negative: height of a bulge) and half width at each point, in millimetres. */
  depths: Float64Array
  halfWidths: Float64Array
  /** Whether the stroke raises the skin, and has no valley. */
  isBulge: boolean
  /** Start and end of this part, as fractions of the stroke's length, 0..1. */
  span: readonly [start: number, end: number]
}

/** Maximum segment length in millimetres. It is well below the width of the thinnest visible wrinkle. */
const MAX_SEGMENT = 0.5
const MAX_SEGMENTS = 8192
/** Maximum total length of strokes in millimetres. */
export const MAX_TOTAL_LENGTH = 100_000
/** Width at a tapered end as a fraction of the stroke's width. The depth is zero there. */
const END_WIDTH = 0.4
/**
 * Default distance from the centre line to the outer end of a bank, in widths of the valley. With this value and `shoulder` 1, the skin has its
 * original height at half a width from the centre line. There, `bankAt` is `12 * x^2 * (1 - x)^2` with `x = 1 / (2 * BANK_WIDTHS)`, and equals
 * `valleyAt`, which is `1 / e`.
 */
export const BANK_WIDTHS = 2.2055
/** Wavelength in millimetres of the noise that makes strokes wavy. A second, weaker octave has 0.4 times this wavelength. */
const WAVELENGTH = 9

/**
 * Converts each stroke to lines on the skin with `layOutStroke`.
 *
 * @returns the parts of each stroke.
 * @throws FurrowError if the total length exceeds `MAX_TOTAL_LENGTH`, because the drawing time grows with the length.
 */
export function layOutStrokes(strokes: readonly Stroke[], skin: LocatedSkin): LaidStroke[][] {
  let left = MAX_TOTAL_LENGTH / MAX_SEGMENT
  return strokes.map((stroke) => {
    const parts = layOutStroke(stroke, skin)
    for (const { depths } of parts) left -= depths.length - 1
    if (left >= 0) return parts
    throw new FurrowError({
      code: 'out-of-range',
      who: 'layOutStrokes',
      problem: 'strokes too long in total',
      value: `${strokes.length} strokes`,
      limit: `${MAX_TOTAL_LENGTH / 1000} m`,
      remedy: 'remove strokes, or check the scale of the document',
    })
  })
}

/** Converts a stroke to lines on the skin. Returns several parts if the stroke is interrupted, none if it is outside the skin. */
export function layOutStroke(stroke: Stroke, skin: LocatedSkin): LaidStroke[] {
  const lines = layCurve(stroke, skin)
  const lengths = lines.map(arcLengths)
  const total = lengths.reduce((sum, along) => sum + along[along.length - 1], 0)
  let before = 0
  return lines.flatMap((line, i) => {
    const start = before
    before += lengths[i][lengths[i].length - 1]
    return before > start ? [shapeLine(stroke, resample(line, lengths[i]), start, before, total)] : []
  })
}

/** Returns whether a stroke raises the skin, and has no valley. */
export function isBulge({ depth }: Pick<Stroke, 'depth'>): boolean {
  return depth < 0
}

/** Returns the reach of a stroke in millimetres. The stroke changes no heights farther than this from its centre line. */
export function reachOf(stroke: LaidStroke): number {
  const reach = stroke.isBulge ? 1 + Math.abs(stroke.lean) : sectionReach(stroke)
  return reach * stroke.halfWidths.reduce((a, b) => Math.max(a, b), 0)
}

export function sectionOf({
  width,
  shoulder,
  bank = [BANK_WIDTHS * width, BANK_WIDTHS * width],
  lean = 0,
  softness,
}: SectionStyle): CrossSection {
  return { shoulder, banks: [(2 * bank[0]) / width, (2 * bank[1]) / width], lean, softness }
}

/** Returns the reach of a cross-section in half widths of the valley. The skin is flat farther than this from the centre line. */
export function sectionReach({ banks, lean }: CrossSection): number {
  return Math.max(VALLEY_REACH * (1 + Math.abs(lean)), ...banks)
}

/** Returns the arc length in millimetres from the start to each point. */
export function arcLengths({ points }: Pick<SkinLine, 'points'>): Float64Array {
  const lengths = new Float64Array(points.length / 3)
  for (let i = 3; i < points.length; i += 3) {
    const step = length3(
      points[i] - points[i - 3],
      points[i + 1] - points[i - 2],
      points[i + 2] - points[i - 1],
    )
    lengths[i / 3] = lengths[i / 3 - 1] + step
  }
  return lengths
}

function resample(line: SkinLine, lengths: Float64Array): SkinLine {
  const length = lengths[lengths.length - 1]
  const segments = clamp(Math.ceil(length / MAX_SEGMENT), 2, MAX_SEGMENTS)
  const points = new Float64Array(3 * segments + 3)
  const normals = new Float64Array(3 * segments + 3)
  let from = 0
  for (let i = 0; i <= segments; i++) {
    const s = (length * i) / segments
    while (from < lengths.length - 2 && lengths[from + 1] < s) from++
    const t = (s - lengths[from]) / (lengths[from + 1] - lengths[from] || 1)
    for (let k = 0; k < 3; k++) {
      points[3 * i + k] = lerp(line.points[3 * from + k], line.points[3 * from + 3 + k], t)
      normals[3 * i + k] = lerp(line.normals[3 * from + k], line.normals[3 * from + 3 + k], t)
    }
    normalize(normals, 3 * i)
  }
  return { points, normals }
}

/**
 * Computes the valley's depth and width along one part of a stroke, and applies the waviness.
 *
 * @param start arc length in millimetres from the start of the stroke to the start of the part.
 * @param end arc length in millimetres from the start of the stroke to the end of the part.
 * @param total length of the complete stroke in millimetres.
 */
function shapeLine(stroke: Stroke, line: SkinLine, start: number, end: number, total: number): LaidStroke {
  const { width, depth, waviness } = stroke
  const segments = line.points.length / 3 - 1
  const [depths, halfWidths] = [new Float64Array(segments + 1), new Float64Array(segments + 1)]
  const points = line.points.slice()
  const seed = seedOf(stroke.points[0])
  const isRaised = isBulge(stroke)
  const right = new Float64Array(3)
  for (let i = 0; i <= segments; i++) {
    const s = lerp(start, end, i / segments)
    const fade = taperAt(s / total, stroke.taper)
    const jitter = (noise(s / WAVELENGTH, seed) + 0.5 * noise(s / (0.4 * WAVELENGTH), seed + 1)) / 1.5
    const offset = 0.4 * width * waviness * jitter
    if (offset !== 0) {
      rightOf(line, i, right)
      for (let k = 0; k < 3; k++) points[3 * i + k] += offset * right[k]
    }
    const shallower = 0.5 * waviness * (0.5 + 0.5 * noise(s / WAVELENGTH, seed + 2))
    depths[i] = depth * fade * depthFactor(stroke.depths, s / total) * (1 - shallower)
    // The ends of a bulge are as wide as its middle, because pointed ends would look like a leaf.
    halfWidths[i] = (width / 2) * (isRaised ? 1 : END_WIDTH + (1 - END_WIDTH) * fade)
  }
  const span = [start / total, end / total] as const
  return {
    points,
    normals: line.normals,
    depths,
    halfWidths,
    ...sectionOf(stroke),
    isBulge: isRaised,
    span,
  }
}

/** Computes the unit vector that is tangent to the skin and points to the right of a line, as seen from outside. */
function rightOf({ points, normals }: SkinLine, i: number, out: Float64Array): void {
  const [from, to] = [3 * Math.max(0, i - 1), Math.min(points.length - 3, 3 * i + 3)]
  const along = [0, 1, 2].map((k) => points[to + k] - points[from + k])
  cross(out, along, normals.subarray(3 * i, 3 * i + 3))
  normalize(out)
}

/** Returns the factor by which tapering reduces a stroke's depth at the fraction `t` of its length: 0 (no depth) to 1 (full depth). */
export function taperAt(t: number, [start, end]: readonly [number, number]): number {
  const fadeIn = start === 0 ? 1 : smoothstep(t / start)
  const fadeOut = end === 0 ? 1 : smoothstep((1 - t) / end)
  return fadeIn * fadeOut
}

/** Interpolates depth factors, evenly spaced along the stroke, at the fraction `t` of its length. */
export function depthFactor(factors: readonly number[] | undefined, t: number): number {
  if (!factors) return 1
  const x = clamp(t, 0, 1) * (factors.length - 1)
  const from = Math.min(Math.floor(x), factors.length - 2)
  return lerp(factors[from], factors[from + 1], x - from)
}

/** Derives a stroke's random seed from its first point, so that results are reproducible. */
function seedOf([u, v]: Uv): number {
  return Math.round(u * 65_521) * 31 + Math.round(v * 65_521) * 7919
}
