import { PointGrid } from '../../../math/point-grid.ts'
import { clamp } from '../../../math/scalar.ts'
import { length2 } from '../../../math/vector.ts'
import type { PeriodicGrid } from './grid-fft.ts'
import type { Relief } from './relief.ts'

/** Bottom line of a valley. */
export interface Valley {
  /** Packed x, y in millimetres from the first sample of the relief. */
  points: number[]
  /** Depth of each point below the ridges beside the valley, in millimetres. */
  depths: number[]
  /** Whether the valley joins another valley at its first point, and at its last point. */
  joins: [first: boolean, last: boolean]
}

export interface ValleySettings {
  /** Distance between points in millimetres. */
  step: number
  /** Returns the distance between wrinkles at a position, in millimetres. */
  wavelength: (x: number, y: number) => number
  /** Returns whether a valley may run through a position. */
  isInside: (x: number, y: number) => boolean
  /** Minimum depth below the mean height, in millimetres. */
  minDepth: number
  /** Minimum length in millimetres. */
  minLength: number
}

/** A valley joins another valley at this distance, in wavelengths. */
const JOIN = 0.28
/** Minimum distance from the start of a valley to other valleys, in wavelengths. */
const KEEP_OUT = 0.36
/** Maximum number of Newton steps towards the bottom of a valley. */
const NEWTON_STEPS = 4
/** Maximum length of a Newton step in millimetres. */
const MAX_NEWTON = 0.6
/** Newton's method stops after a step that is shorter than this, in millimetres. */
const CONVERGED = 0.01
/** Minimum cosine of the angle by which a valley turns in one step. */
const MIN_COSINE = 0.6
/** Maximum distance between a valley and the ridges beside it, in wavelengths. */
const RIDGE_RANGE = 0.75
/** Number of samples on each side of a valley, to find the ridge. */
const RIDGE_SAMPLES = 16

/** Position on the bottom line of a valley, and the unit direction of this line. */
interface Bottom {
  x: number
  y: number
  alongX: number
  alongY: number
  height: number
}

/**
 * Traces each valley of a relief in both directions from its deepest point. A valley that comes close to another one ends in it, so that the
 * two form a fork.
 */
export function traceValleys(relief: Relief, settings: ValleySettings): Valley[] {
  const { grid, heights } = relief
  const valleys: Valley[] = []
  const order = Array.from(heights, (_, i) => i)
    .filter((i) => heights[i] < -settings.minDepth && settings.isInside(...positionOf(i, grid)))
    .sort((a, b) => heights[a] - heights[b] || a - b)
  const lambdas = order.map((i) => settings.wavelength(...positionOf(i, grid)))
  const traced = new TracedPoints(KEEP_OUT * lambdas.reduce((a, b) => Math.max(a, b), settings.step))
  for (const i of order) {
    const [x, y] = positionOf(i, grid)
    if (traced.nearest(x, y, KEEP_OUT * settings.wavelength(x, y))) continue
    const start = bottomNear(relief, x, y)
    if (!start || start.height > -settings.minDepth || !settings.isInside(start.x, start.y)) continue
    if (traced.nearest(start.x, start.y, KEEP_OUT * settings.wavelength(start.x, start.y))) continue
    const forwards = follow(relief, settings, traced, start, 1)
    const backwards = follow(relief, settings, traced, start, -1)
    const points = [...reversed(backwards.points), start.x, start.y, ...forwards.points]
    if ((points.length / 2 - 1) * settings.step < settings.minLength) continue
    traced.add(points)
    valleys.push({
      points,
      depths: depthsBelowRidges(relief, settings, points),
      joins: [backwards.joins, forwards.joins],
    })
  }
  return valleys
}

/** Returns a valley with its first point last. */
export function reversedValley({ points, depths, joins: [first, last] }: Valley): Valley {
  return { points: reversed(points), depths: [...depths].reverse(), joins: [last, first] }
}

/** Returns the position of a sample. */
function positionOf(sample: number, { width, spacing }: PeriodicGrid): [x: number, y: number] {
  return [(sample % width) * spacing, Math.floor(sample / width) * spacing]
}

/** Points of traced valleys, searchable by position. */
class TracedPoints {
  readonly #grid: PointGrid
  readonly #points: number[] = []

  /** @param reach maximum search radius. */
  constructor(reach: number) {
    this.#grid = new PointGrid(reach)
  }

  add(points: readonly number[]): void {
    for (let i = 0; i < points.length; i += 2) this.#grid.add([points[i], points[i + 1], 0])
    this.#points.push(...points)
  }

  /** Returns the nearest point within a radius, if any. */
  nearest(x: number, y: number, radius: number): readonly [x: number, y: number] | undefined {
    let [found, least] = [-1, radius * radius]
    this.#grid.visitNear([x, y, 0], (point, square) => {
      if (square < least || (square === least && point < found)) [found, least] = [point, square]
    })
    return found < 0 ? undefined : [this.#points[2 * found], this.#points[2 * found + 1]]
  }
}

/** Follows a valley from a point until the valley becomes shallow, turns sharply, leaves the region given by `isInside`, or meets another valley. */
function follow(
  relief: Relief,
  { step, wavelength, isInside, minDepth }: ValleySettings,
  traced: TracedPoints,
  start: Bottom,
  sign: 1 | -1,
): { points: number[]; joins: boolean } {
  const points: number[] = []
  let { x, y } = start
  let [alongX, alongY] = [sign * start.alongX, sign * start.alongY]
  const { width, height, spacing } = relief.grid
  const maxPoints = ((width + height) * spacing) / step
  while (points.length < 2 * maxPoints) {
    const next = bottomNear(relief, x + step * alongX, y + step * alongY)
    if (!next || next.height > -minDepth || !isInside(next.x, next.y)) break
    const [dx, dy] = [next.x - x, next.y - y]
    const advance = dx * alongX + dy * alongY
    if (length2(dx, dy) > 2 * step || advance < 0.3 * step) break
    const cosine = next.alongX * alongX + next.alongY * alongY
    if (Math.abs(cosine) < MIN_COSINE) break
    x = next.x
    y = next.y
    const other = traced.nearest(x, y, JOIN * wavelength(x, y))
    if (other) {
      points.push(...joined([x, y], other, step))
      return { points, joins: true }
    }
    alongX = cosine < 0 ? -next.alongX : next.alongX
    alongY = cosine < 0 ? -next.alongY : next.alongY
    points.push(x, y)
  }
  return { points, joins: false }
}

/** Returns evenly spaced points from one position to another. */
function joined([x, y]: readonly number[], [toX, toY]: readonly number[], step: number): number[] {
  const count = Math.max(1, Math.round(length2(toX - x, toY - y) / step))
  return Array.from({ length: count }, (_, i) => (i + 1) / count).flatMap((t) => [
    x + t * (toX - x),
    y + t * (toY - y),
  ])
}

/** Finds the bottom of the valley near a position by Newton's method across the valley; undefined on ridges. */
function bottomNear(relief: Relief, x: number, y: number): Bottom | undefined {
  let [px, py] = [x, y]
  for (let i = 0; i < NEWTON_STEPS; i++) {
    const at = relief.at(px, py)
    const across = steepestAxis(at)
    if (across.curvature <= 0) return undefined
    const slope = at.x * across.x + at.y * across.y
    const move = clamp(-slope / across.curvature, -MAX_NEWTON, MAX_NEWTON)
    px += move * across.x
    py += move * across.y
    if (Math.abs(move) < CONVERGED) break
  }
  const at = relief.at(px, py)
  const across = steepestAxis(at)
  if (across.curvature <= 0) return undefined
  return { x: px, y: py, alongX: -across.y, alongY: across.x, height: at.height }
}

/** Returns the unit direction of the largest second derivative: an eigenvector of the Hessian, computed without trigonometry. */
function steepestAxis({ xx, xy, yy }: { xx: number; xy: number; yy: number }) {
  const half = (xx - yy) / 2
  const radius = length2(half, xy)
  const curvature = (xx + yy) / 2 + radius
  // (half + radius, xy) and (xy, radius - half) are parallel eigenvectors. In the longer one, no subtraction loses precision.
  const [x, y] = half > 0 ? [half + radius, xy] : [xy, radius - half]
  const size = length2(x, y)
  return size > 0 ? { x: x / size, y: y / size, curvature } : { x: 1, y: 0, curvature }
}

/** Returns the depth of each point of a valley below the mean height of the two ridges beside it. */
function depthsBelowRidges(
  relief: Relief,
  { wavelength }: ValleySettings,
  points: readonly number[],
): number[] {
  const count = points.length / 2
  return Array.from({ length: count }, (_, i) => {
    const [before, after] = [2 * Math.max(i - 1, 0), 2 * Math.min(i + 1, count - 1)]
    const [dx, dy] = [points[after] - points[before], points[after + 1] - points[before + 1]]
    const size = length2(dx, dy) || 1
    const [x, y] = [points[2 * i], points[2 * i + 1]]
    const reach = (RIDGE_RANGE * wavelength(x, y)) / RIDGE_SAMPLES
    const ridge = (sign: number) => {
      let highest = -Infinity
      for (let k = 1; k <= RIDGE_SAMPLES; k++) {
        const distance = sign * k * reach
        const { height } = relief.at(x - (distance * dy) / size, y + (distance * dx) / size)
        highest = Math.max(highest, height)
      }
      return highest
    }
    return Math.max(0, (ridge(1) + ridge(-1)) / 2 - relief.at(x, y).height)
  })
}

/** Returns packed points in reverse order. */
function reversed(points: readonly number[]): number[] {
  const out: number[] = []
  for (let i = points.length - 2; i >= 0; i -= 2) out.push(points[i], points[i + 1])
  return out
}
