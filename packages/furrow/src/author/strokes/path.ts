import type { Uv } from '../../core/json.ts'
import { bezierAt } from '../../math/bezier.ts'
import { smoothstep } from '../../math/scalar.ts'
import { type Metric, metricAt } from '../metric.ts'
import type { Stroke } from './document.ts'

/** A stroke laid out on the skin: short straight pieces with the wrinkle's strength along the way. */
export interface Path {
  /** u, v per point. */
  points: Float64Array
  /** Share of the stroke's depth per point, 0..1: taper and irregularity together. */
  depth: Float64Array
  /** Share of the stroke's width per point, 0..1. */
  width: Float64Array
}

/** Longest piece of a path in millimetres: well below the thinnest wrinkle worth drawing. */
const STEP = 0.5

/** Pieces a Bezier curve is cut into before it is measured. */
const BEZIER_PIECES = 32

/** Width that is left at a tapered end, where the depth is zero: a crease ends in a hairline. */
const END_WIDTH = 0.4

/** Millimetres between the sways of a wavy line; a second, weaker sway has 0.4 of it. */
const SWAY = 9

/** Lays a stroke out on the skin. The same stroke gives the same path on every run. */
export function layOut(stroke: Stroke, metric: Metric): Path {
  const raw = stroke.curve === 'bezier' ? cutBezier(stroke.points) : stroke.points
  const form = new Float64Array(3)
  const lengths = measure(raw, metric, form)
  const total = lengths[lengths.length - 1]
  const pieces = Math.max(Math.ceil(total / STEP), 2)
  const path: Path = {
    points: new Float64Array(2 * (pieces + 1)),
    depth: new Float64Array(pieces + 1),
    width: new Float64Array(pieces + 1),
  }
  const seed = seedOf(stroke.points[0])
  let k = 0
  for (let i = 0; i <= pieces; i++) {
    const at = (total * i) / pieces
    while (k < raw.length - 2 && lengths[k + 1] < at) k++
    const share = (at - lengths[k]) / Math.max(lengths[k + 1] - lengths[k], 1e-12)
    const a = raw[k]
    const b = raw[k + 1]
    const u = a[0] + share * (b[0] - a[0])
    const v = a[1] + share * (b[1] - a[1])
    const fade = taper(i / pieces, stroke.taper)
    const sway = (noise(at / SWAY, seed) + 0.5 * noise(at / (0.4 * SWAY), seed + 1)) / 1.5
    const aside = 0.4 * stroke.width * stroke.waviness * sway
    metricAt(metric, u, v, form)
    const [across, down] = perpendicular(b[0] - a[0], b[1] - a[1], form)
    path.points[2 * i] = u + aside * across
    path.points[2 * i + 1] = v + aside * down
    path.depth[i] = fade * (1 - 0.5 * stroke.waviness * (0.5 + 0.5 * noise(at / SWAY, seed + 2)))
    path.width[i] = END_WIDTH + (1 - END_WIDTH) * fade
  }
  return path
}

function cutBezier(points: Uv[]): Uv[] {
  const cut: Uv[] = [points[0]]
  for (let i = 0; i + 3 < points.length; i += 3) {
    const [a, b, c, d] = [points[i], points[i + 1], points[i + 2], points[i + 3]]
    for (let k = 1; k <= BEZIER_PIECES; k++) cut.push(bezierAt(a, b, c, d, k / BEZIER_PIECES))
  }
  return cut
}

/** Millimetres from the start to every point of a line. */
function measure(points: Uv[], metric: Metric, form: Float64Array): Float64Array {
  const lengths = new Float64Array(points.length)
  for (let i = 1; i < points.length; i++) {
    const [a, b] = [points[i - 1], points[i]]
    const [du, dv] = [b[0] - a[0], b[1] - a[1]]
    metricAt(metric, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, form)
    lengths[i] = lengths[i - 1] + Math.sqrt(form[0] * du * du + 2 * form[1] * du * dv + form[2] * dv * dv)
  }
  return lengths
}

/** The step in (u, v) of one millimetre at a right angle to (du, dv) on the skin. */
function perpendicular(du: number, dv: number, form: Float64Array): [number, number] {
  const [uu, uv, vv] = [form[0], form[1], form[2]]
  const length = Math.sqrt(uu * du * du + 2 * uv * du * dv + vv * dv * dv)
  const scale = Math.sqrt(Math.max(uu * vv - uv * uv, 0)) * length
  return scale === 0 ? [0, 0] : [-(uv * du + vv * dv) / scale, (uu * du + uv * dv) / scale]
}

function taper(share: number, [start, end]: [number, number]): number {
  const head = start === 0 ? 1 : smoothstep(share / start)
  const tail = end === 0 ? 1 : smoothstep((1 - share) / end)
  return head * tail
}

/** Smooth noise of one variable, -1..1: random values at the whole numbers, joined by smoothstep. */
function noise(x: number, seed: number): number {
  const cell = Math.floor(x)
  const a = random(cell, seed)
  return a + (random(cell + 1, seed) - a) * smoothstep(x - cell)
}

/** -1..1 from two whole numbers; the bit mixer is the 32-bit finaliser of MurmurHash3 (Appleby 2011). */
function random(cell: number, seed: number): number {
  let h = Math.imul(cell, 0x9e3779b1) ^ Math.imul(seed, 0x85ebca6b)
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b)
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35)
  return ((h ^ (h >>> 16)) >>> 0) / 0x7fffffff - 1
}

/** Strokes sway differently because they start in different places, and alike on every run. */
function seedOf([u, v]: Uv): number {
  return Math.round(u * 65_521) * 31 + Math.round(v * 65_521) * 7919
}
