import type { Uv } from '../../core/json.ts'
import { bezierAt } from '../../math/bezier.ts'
import { lerp } from '../../math/scalar.ts'
import { splineAt } from '../../math/spline.ts'
import { dot, length, length2, length3 } from '../../math/vector.ts'
import type { SkinCanvas } from '../skin/canvas.ts'
import type { SkinSurface } from '../skin/surface.ts'
import { barycentricsAt, normalAt, positionAt, walk } from '../skin/walk.ts'
import type { Stroke } from './document.ts'

/** Number of straight segments that approximate one Bezier curve. */
const BEZIER_SEGMENTS = 32
/** Maximum step of a curve in UV space. It is about a third of a millimetre on a face that fills the texture. */
const MAX_UV_STEP = 1 / 1024
/** Maximum step of a spline in millimetres. */
const MAX_STEP = 0.5
/** Approximate maximum number of steps of a curve. */
const MAX_STEPS = 8192
/** Maximum distance in millimetres that a step of `MAX_UV_STEP` covers on the skin. A longer step has entered another UV island. */
const JUMP = 10

/** Line on the skin. */
export interface SkinLine {
  /** Packed xyz in millimetres. */
  points: Float64Array
  /** Unit normals of the skin at the points, packed xyz. */
  normals: Float64Array
}

/** Line on the skin, with the triangle that contains each point. */
export interface TracedLine extends SkinLine {
  triangles: readonly number[]
}

/** Triangles of the skin, and a locator that finds the triangle at UV coordinates. */
export type LocatedSkin = Pick<SkinCanvas, 'surface' | 'locator'>

/**
 * Converts the curve of a stroke (a wrinkle) from UV space to lines on the skin, in short steps.
 *
 * @returns parts of the curve, each with at least two points. A polyline or a Bezier curve is interrupted at UV coordinates without skin. A
 *   spline ignores control points at such coordinates.
 */
export function layCurve(
  { curve, points }: Pick<Stroke, 'curve' | 'points'>,
  skin: LocatedSkin,
): TracedLine[] {
  if (curve === 'spline') return laySpline(points, skin)
  return layInTexture(curve === 'bezier' ? flattenBezier(points) : points, skin)
}

function flattenBezier(points: readonly Uv[]): Uv[] {
  const polyline: Uv[] = [points[0]]
  for (let i = 0; i + 3 < points.length; i += 3) {
    const [a, b, c, d] = points.slice(i, i + 4)
    for (let k = 1; k <= BEZIER_SEGMENTS; k++) polyline.push(bezierAt(a, b, c, d, k / BEZIER_SEGMENTS))
  }
  return polyline
}

/** Converts a UV polyline to lines on the skin: looks up the position on the skin at each step. */
function layInTexture(polyline: readonly Uv[], { surface, locator }: LocatedSkin): TracedLine[] {
  const lines: TracedLine[] = []
  const trail = new Trail(surface)
  const [position, weights] = [new Float64Array(3), new Float64Array(3)]
  const step = Math.max(MAX_UV_STEP, lengthOf(polyline) / MAX_STEPS)
  for (const [u, v] of stepsAlong(polyline, step)) {
    const triangle = locator.find(u, v, weights)
    if (triangle >= 0) positionAt(position, surface, triangle, weights)
    if (triangle < 0 || trail.distanceTo(position) > (JUMP * step) / MAX_UV_STEP) lines.push(...trail.end())
    if (triangle >= 0) trail.add(position, triangle, weights)
  }
  return [...lines, ...trail.end()]
}

function lengthOf(polyline: readonly Uv[]): number {
  let sum = 0
  for (let i = 1; i < polyline.length; i++) sum += uvDistance(polyline[i - 1], polyline[i])
  return sum
}

function uvDistance(a: Uv, b: Uv): number {
  return length2(b[0] - a[0], b[1] - a[1])
}

function* stepsAlong(polyline: readonly Uv[], step: number): Generator<Uv> {
  yield polyline[0]
  for (let i = 1; i < polyline.length; i++) {
    const [from, to] = [polyline[i - 1], polyline[i]]
    const steps = Math.ceil(uvDistance(from, to) / step)
    for (let k = 1; k <= steps; k++) yield [lerp(from[0], to[0], k / steps), lerp(from[1], to[1], k / steps)]
  }
}

/** Converts a spline to a line on the skin: walks over the skin along a smooth 3D curve through the control points. */
function laySpline(uvs: readonly Uv[], { surface, locator }: LocatedSkin): TracedLine[] {
  const [position, weights] = [new Float64Array(3), new Float64Array(3)]
  const anchors: number[] = []
  const triangles: number[] = []
  for (const [u, v] of uvs) {
    const triangle = locator.find(u, v, weights)
    if (triangle < 0) continue
    positionAt(position, surface, triangle, weights)
    if (triangles.length > 0 && distance(position, anchors.slice(-3)) === 0) continue
    anchors.push(...position)
    triangles.push(triangle)
  }
  const trail = new Trail(surface)
  const maxSteps = Math.ceil(MAX_STEPS / anchors.length)
  for (const [i, triangle] of triangles.entries()) {
    position.set(anchors.slice(3 * i, 3 * i + 3))
    barycentricsAt(weights, surface, triangle, position)
    trail.add(position, triangle, weights)
    if (i + 1 === triangles.length) break
    const chord = distance(position, anchors.slice(3 * i + 3, 3 * i + 6))
    const steps = Math.min(maxSteps, Math.ceil(chord / MAX_STEP))
    trail.follow(position, triangle, steps, (target, t) => splineAt(target, anchors, i, t))
  }
  return trail.end()
}

function distance(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return length3(b[0] - a[0], b[1] - a[1], b[2] - a[2])
}

class Trail {
  readonly #surface: SkinSurface
  #points: number[] = []
  #normals: number[] = []
  #triangles: number[] = []
  readonly #normal = new Float64Array(3)

  constructor(surface: SkinSurface) {
    this.#surface = surface
  }

  add(position: Float64Array, triangle: number, weights: Float64Array): void {
    normalAt(this.#normal, this.#surface, triangle, weights)
    this.#points.push(...position)
    this.#normals.push(...this.#normal)
    this.#triangles.push(triangle)
  }

  /**
   * Adds the points of a curve between two control points. The points are projected onto the skin until the curve passes the skin's border.
   * Later points are added without projection.
   */
  follow(
    position: Float64Array,
    start: number,
    steps: number,
    curveAt: (out: Float64Array, t: number) => void,
  ): void {
    const [target, weights] = [new Float64Array(3), new Float64Array(3)]
    let [triangle, isOnSkin] = [start, true]
    for (let k = 1; k < steps; k++) {
      curveAt(target, k / steps)
      if (isOnSkin) {
        const next = this.#walkTowards(target, triangle, position)
        isOnSkin = next >= 0
        if (isOnSkin) triangle = next
      }
      if (!isOnSkin) position.set(target)
      barycentricsAt(weights, this.#surface, triangle, position)
      this.add(position, triangle, weights)
    }
  }

  /** Moves `position` over the skin to the point directly below or above a target. Returns the triangle there, or -1 at the skin's border. */
  #walkTowards(target: Float64Array, triangle: number, position: Float64Array): number {
    const direction = target.map((value, k) => value - position[k])
    const rise = dot(direction, this.#normal)
    for (let k = 0; k < 3; k++) direction[k] -= rise * this.#normal[k]
    return walk(this.#surface, triangle, position, direction, length(direction))
  }

  /** Returns the distance from a position to the last added point, or 0 before the first point. */
  distanceTo(position: ArrayLike<number>): number {
    return this.#points.length > 0 ? distance(position, this.#points.slice(-3)) : 0
  }

  /** Ends the line, and returns it if it has at least two points. The next point starts a new line. */
  end(): TracedLine[] {
    const line = {
      points: Float64Array.from(this.#points),
      normals: Float64Array.from(this.#normals),
      triangles: this.#triangles,
    }
    this.#points = []
    this.#normals = []
    this.#triangles = []
    return line.points.length >= 6 ? [line] : []
  }
}
