import type { Uv } from '../../core/json.ts'
import { bezierAt } from '../../math/bezier.ts'
import { hash32 } from '../../math/hash.ts'
import { quadraticForm } from '../../math/quadratic-form.ts'
import { lerp, smoothstep } from '../../math/scalar.ts'
import { type Metric, metricAt } from '../metric.ts'
import type { Stroke } from './document.ts'

/** A stroke laid out on the skin as a polyline of short segments. */
export interface Path {
  /** u and v of each point. */
  points: Float64Array
  /** Factor on the stroke's depth at each point, 0..1: taper times irregularity. */
  depth: Float64Array
  /** Factor on the stroke's width at each point, 0..1. */
  width: Float64Array
}

/** Longest segment in millimetres: well below the thinnest visible wrinkle. */
const MAX_SEGMENT = 0.5

/** Segments into which a Bezier curve is cut before it is measured. */
const BEZIER_SEGMENTS = 32

/** Width left at a tapered end, where the depth is zero: a crease ends in a hairline. */
const END_WIDTH = 0.4

/** Wavelength of the irregularity in millimetres; a second, weaker octave has 0.4 of it. */
const WAVELENGTH = 9

/** Lays a stroke out on the skin. The same stroke gives the same path on every run. */
export function layOutStroke(stroke: Stroke, metric: Metric): Path {
  const polyline = stroke.curve === 'bezier' ? flattenBezier(stroke.points) : stroke.points
  const form = new Float64Array(3)
  const lengths = arcLengths(polyline, metric, form)
  const total = lengths[lengths.length - 1]
  const segments = Math.max(Math.ceil(total / MAX_SEGMENT), 2)
  const path: Path = {
    points: new Float64Array(2 * (segments + 1)),
    depth: new Float64Array(segments + 1),
    width: new Float64Array(segments + 1),
  }
  const seed = seedOf(stroke.points[0])
  let k = 0
  for (let i = 0; i <= segments; i++) {
    const s = (total * i) / segments
    while (k < polyline.length - 2 && lengths[k + 1] < s) k++
    const t = (s - lengths[k]) / Math.max(lengths[k + 1] - lengths[k], 1e-12)
    const [a, b] = [polyline[k], polyline[k + 1]]
    const [u, v] = [lerp(a[0], b[0], t), lerp(a[1], b[1], t)]
    const fade = taperAt(i / segments, stroke.taper)
    const jitter = (noise(s / WAVELENGTH, seed) + 0.5 * noise(s / (0.4 * WAVELENGTH), seed + 1)) / 1.5
    const offset = 0.4 * stroke.width * stroke.waviness * jitter
    metricAt(metric, u, v, form)
    const [du, dv] = perpendicular(b[0] - a[0], b[1] - a[1], form)
    path.points[2 * i] = u + offset * du
    path.points[2 * i + 1] = v + offset * dv
    path.depth[i] = fade * (1 - 0.5 * stroke.waviness * (0.5 + 0.5 * noise(s / WAVELENGTH, seed + 2)))
    path.width[i] = END_WIDTH + (1 - END_WIDTH) * fade
  }
  return path
}

function flattenBezier(points: Uv[]): Uv[] {
  const polyline: Uv[] = [points[0]]
  for (let i = 0; i + 3 < points.length; i += 3) {
    const [a, b, c, d] = points.slice(i, i + 4)
    for (let k = 1; k <= BEZIER_SEGMENTS; k++) polyline.push(bezierAt(a, b, c, d, k / BEZIER_SEGMENTS))
  }
  return polyline
}

/** Millimetres along a polyline from its start to each point. */
function arcLengths(polyline: Uv[], metric: Metric, form: Float64Array): Float64Array {
  const lengths = new Float64Array(polyline.length)
  for (let i = 1; i < polyline.length; i++) {
    const [a, b] = [polyline[i - 1], polyline[i]]
    metricAt(metric, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, form)
    const squared = quadraticForm(form[0], form[1], form[2], b[0] - a[0], b[1] - a[1])
    lengths[i] = lengths[i - 1] + Math.sqrt(squared)
  }
  return lengths
}

/** The step in (u, v) of one millimetre at a right angle to (du, dv) on the skin. */
function perpendicular(du: number, dv: number, form: Float64Array): [number, number] {
  const [uu, uv, vv] = [form[0], form[1], form[2]]
  const length = Math.sqrt(quadraticForm(uu, uv, vv, du, dv))
  const scale = Math.sqrt(Math.max(uu * vv - uv * uv, 0)) * length
  return scale === 0 ? [0, 0] : [-(uv * du + vv * dv) / scale, (uu * du + uv * dv) / scale]
}

function taperAt(t: number, [start, end]: [number, number]): number {
  const fadeIn = start === 0 ? 1 : smoothstep(t / start)
  const fadeOut = end === 0 ? 1 : smoothstep((1 - t) / end)
  return fadeIn * fadeOut
}

/** Value noise in one dimension, -1..1: random values at whole numbers, joined by smoothstep. */
function noise(x: number, seed: number): number {
  const cell = Math.floor(x)
  return lerp(randomAt(cell, seed), randomAt(cell + 1, seed), smoothstep(x - cell))
}

/** -1..1 from two whole numbers. */
function randomAt(cell: number, seed: number): number {
  return hash32(Math.imul(cell, 0x9e3779b1) ^ Math.imul(seed, 0x85ebca6b)) / 0x7fffffff - 1
}

/** From where a stroke starts, so that strokes differ and runs do not. */
function seedOf([u, v]: Uv): number {
  return Math.round(u * 65_521) * 31 + Math.round(v * 65_521) * 7919
}
