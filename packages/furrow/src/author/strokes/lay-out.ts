import { FurrowError } from '../../core/error.ts'
import type { Uv } from '../../core/json.ts'
import { noise } from '../../math/noise.ts'
import { clamp, lerp, smoothstep } from '../../math/scalar.ts'
import { cross, length3, normalize } from '../../math/vector.ts'
import { type LocatedSkin, layCurve, type SkinLine } from './curve.ts'
import type { Stroke } from './document.ts'
import { VALLEY_REACH } from './profile.ts'

/** What of a stroke shapes its cross-section. */
export type SectionStyle = Readonly<
  Pick<Stroke, 'width' | 'softness'> & {
    shoulder: CrossSection['shoulder']
    bank?: CrossSection['banks'] | undefined
    lean?: number | undefined
  }
>

/** How the cross-section of a stroke is shaped, relative to the valley's depth and half its width. */
export interface CrossSection {
  /** Height of the raised banks, left and right of its direction as seen from outside, 0..1. */
  shoulder: readonly [left: number, right: number]
  /** How far the banks reach, left and right, in half widths. */
  banks: readonly [left: number, right: number]
  lean: number
  softness: number
}

/** A stroke on the skin, with its cross-section at each point. */
export interface LaidStroke extends SkinLine, CrossSection {
  /** Depth of the valley and half its width at each point, in millimetres. */
  depths: Float64Array
  halfWidths: Float64Array
  /** Where on the stroke its part begins and ends, as fractions of the length, 0..1. */
  span: readonly [start: number, end: number]
}

/** Longest segment in millimetres: well below the thinnest visible wrinkle. */
const MAX_SEGMENT = 0.5
/** Segments of the longest stroke. */
const MOST_SEGMENTS = 8192
/** Length of all strokes together in millimetres: lines a millimetre apart, all over a face of 300 mm a side, have 90 m. */
export const MOST_MILLIMETRES = 100_000
/** Width left at a tapered end, where the depth is zero: a crease ends in a hairline. */
const END_WIDTH = 0.4
/**
 * How far banks reach by default, in widths: with full shoulders the valley and its banks are at the height of the smooth skin half a width from
 * the bottom, where 12 x^2 (1 - x)^2 = 1/e, x = 1/2 / BANK_WIDTHS.
 */
export const BANK_WIDTHS = 2.2055
/** Wavelength of the irregularity in millimetres; a second, weaker octave has 0.4 of it. */
const WAVELENGTH = 9

/**
 * Lays strokes on the skin, see `layOutStroke`.
 *
 * @returns the parts of each.
 * @throws FurrowError where they are too long together: each costs a search in all texels near it.
 */
export function layOutStrokes(strokes: readonly Stroke[], skin: LocatedSkin): LaidStroke[][] {
  let left = MOST_MILLIMETRES / MAX_SEGMENT
  return strokes.map((stroke) => {
    const parts = layOutStroke(stroke, skin)
    for (const { depths } of parts) left -= depths.length - 1
    if (left >= 0) return parts
    throw new FurrowError({
      code: 'out-of-range',
      who: 'layOutStrokes',
      problem: 'the strokes are too long together',
      value: `${strokes.length} strokes`,
      limit: `${MOST_MILLIMETRES / 1000} m`,
      remedy: 'leave some of them out, or check the scale of the document',
    })
  })
}

/** Lays a stroke on the skin, in one part or several; in none where the skin has no such texels. The same stroke gives the same on every run. */
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

/** How far from its middle a stroke is drawn, in millimetres. */
export function reachOf(stroke: LaidStroke): number {
  return sectionReach(stroke) * stroke.halfWidths.reduce((a, b) => Math.max(a, b), 0)
}

/** The cross-section of a stroke. */
export function sectionOf({
  width,
  shoulder,
  bank = [BANK_WIDTHS * width, BANK_WIDTHS * width],
  lean = 0,
  softness,
}: SectionStyle): CrossSection {
  return { shoulder, banks: [(2 * bank[0]) / width, (2 * bank[1]) / width], lean, softness }
}

/** How far a cross-section reaches from its middle, in half widths. */
export function sectionReach({ banks, lean }: CrossSection): number {
  return Math.max(VALLEY_REACH * (1 + Math.abs(lean)), ...banks)
}

/** Distances in millimetres from the start to each point. */
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

/** The same line in equal segments. */
function resample(line: SkinLine, lengths: Float64Array): SkinLine {
  const length = lengths[lengths.length - 1]
  const segments = clamp(Math.ceil(length / MAX_SEGMENT), 2, MOST_SEGMENTS)
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
 * Gives a line its cross-sections.
 *
 * @param start, end of the line along the stroke, and the stroke's whole length, in millimetres.
 */
function shapeLine(stroke: Stroke, line: SkinLine, start: number, end: number, total: number): LaidStroke {
  const { width, depth, waviness } = stroke
  const segments = line.points.length / 3 - 1
  const [depths, halfWidths] = [new Float64Array(segments + 1), new Float64Array(segments + 1)]
  const points = line.points.slice()
  const seed = seedOf(stroke.points[0])
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
    halfWidths[i] = (width / 2) * (END_WIDTH + (1 - END_WIDTH) * fade)
  }
  const span = [start / total, end / total] as const
  return { points, normals: line.normals, depths, halfWidths, ...sectionOf(stroke), span }
}

/** The unit vector to the right of a line at one of its points, in the skin as seen from outside. */
function rightOf({ points, normals }: SkinLine, i: number, out: Float64Array): void {
  const [from, to] = [3 * Math.max(0, i - 1), Math.min(points.length - 3, 3 * i + 3)]
  const along = [0, 1, 2].map((k) => points[to + k] - points[from + k])
  cross(out, along, normals.subarray(3 * i, 3 * i + 3))
  normalize(out)
}

export function taperAt(t: number, [start, end]: readonly [number, number]): number {
  const fadeIn = start === 0 ? 1 : smoothstep(t / start)
  const fadeOut = end === 0 ? 1 : smoothstep((1 - t) / end)
  return fadeIn * fadeOut
}

/** Interpolates factors that are evenly spaced over 0..1. */
export function depthFactor(factors: readonly number[] | undefined, t: number): number {
  if (!factors) return 1
  const x = clamp(t, 0, 1) * (factors.length - 1)
  const from = Math.min(Math.floor(x), factors.length - 2)
  return lerp(factors[from], factors[from + 1], x - from)
}

/** From where a stroke starts, so that strokes differ and runs do not. */
function seedOf([u, v]: Uv): number {
  return Math.round(u * 65_521) * 31 + Math.round(v * 65_521) * 7919
}
