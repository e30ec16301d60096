import { barycentrics3, interpolate } from '../../../math/barycentrics.ts'
import { triangleNormal } from '../../../math/triangle.ts'
import { dot, normalize } from '../../../math/vector.ts'
import { cornersOf, type SkinSurface, type SurfacePoint } from '../../skin/surface.ts'

/** Millimetres between points of a line. */
export const STEP = 0.6

/** Fraction of the way to a triangle's centroid that a line is pulled as it enters. */
const INWARDS = 1e-3

/** A line on a surface. */
export interface Trace {
  /** x, y and z of each point. */
  points: number[]
  /** The surface's normals there. */
  normals: number[]
}

/**
 * Chooses the direction in which a line continues.
 *
 * @param position where it is.
 * @param normal of the surface there.
 * @param triangle and barycentrics, to interpolate what is known at points.
 * @param out takes x, y and z.
 * @returns whether the line continues.
 */
export type DirectionField = (
  position: Float64Array,
  normal: Float64Array,
  triangle: number,
  barycentrics: Float64Array,
  out: Float64Array,
) => boolean

/**
 * Traces a line over a surface from triangle to triangle, until the field or the surface ends.
 *
 * @param maxLength in millimetres.
 */
export function traceLine(
  surface: SkinSurface,
  start: SurfacePoint,
  field: DirectionField,
  maxLength: number,
): Trace {
  const position = Float64Array.from(start.position)
  const [normal, direction, weights] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)]
  const trace: Trace = { points: [], normals: [] }
  let triangle = start.triangle
  for (let length = 0; length <= maxLength; length += STEP) {
    barycentricsAt(weights, surface, triangle, position)
    const [a, b, c] = cornersOf(surface, triangle)
    interpolate(normal, surface.normals, 3, a, b, c, weights[0], weights[1], weights[2])
    normalize(normal)
    trace.points.push(...position)
    trace.normals.push(...normal)
    if (!field(position, normal, triangle, weights, direction)) break
    triangle = walk(surface, triangle, position, direction)
    if (triangle < 0) break
  }
  return trace
}

/** Moves a position by one `STEP` over as many triangles as it crosses; returns the last one, or -1 at the surface's border. */
function walk(surface: SkinSurface, start: number, position: Float64Array, direction: Float64Array): number {
  let triangle = start
  let left = STEP
  const here = new Float64Array(3)
  const there = new Float64Array(3)
  const target = new Float64Array(3)
  // A step of half a millimetre rarely crosses more than two.
  for (let crossed = 0; crossed < 8; crossed++) {
    projectOntoTriangle(target, surface, triangle, direction)
    for (let k = 0; k < 3; k++) target[k] = position[k] + left * target[k]
    barycentricsAt(here, surface, triangle, position)
    barycentricsAt(there, surface, triangle, target)
    // The first edge that the step crosses, and at what fraction of it.
    let [fraction, edge] = [1, -1]
    for (let k = 0; k < 3; k++) {
      if (there[k] >= 0) continue
      const crossing = Math.max(here[k], 0) / (Math.max(here[k], 0) - there[k])
      if (crossing < fraction || edge < 0) [fraction, edge] = [crossing, (k + 1) % 3]
    }
    for (let k = 0; k < 3; k++) position[k] += fraction * (target[k] - position[k])
    if (edge < 0) return triangle
    left *= 1 - fraction
    const next = surface.adjacent[3 * triangle + edge]
    if (next < 0) return -1
    triangle = next
    pullInwards(surface, triangle, position)
    if (left < 1e-6) return triangle
  }
  return triangle
}

/** Keeps a line that runs along an edge or through a corner from alternating between two triangles. */
function pullInwards(surface: SkinSurface, triangle: number, position: Float64Array): void {
  const corners = cornersOf(surface, triangle)
  for (let k = 0; k < 3; k++) {
    let middle = 0
    for (const point of corners) middle += surface.points[3 * point + k] / 3
    position[k] += INWARDS * (middle - position[k])
  }
}

/** Projects a direction onto a triangle's plane, at length 1. */
function projectOntoTriangle(
  out: Float64Array,
  surface: SkinSurface,
  triangle: number,
  direction: Float64Array,
): void {
  const [a, b, c] = cornersOf(surface, triangle)
  triangleNormal(out, surface.points, a, b, c)
  const rise = dot(out, direction) / dot(out, out)
  for (let k = 0; k < 3; k++) out[k] = direction[k] - rise * out[k]
  normalize(out)
}

function barycentricsAt(
  out: Float64Array,
  surface: SkinSurface,
  triangle: number,
  position: Float64Array,
): void {
  const [a, b, c] = cornersOf(surface, triangle)
  barycentrics3(out, surface.points, a, b, c, position)
}
