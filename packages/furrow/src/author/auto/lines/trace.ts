import type { SkinSurface, SurfacePoint } from '../../skin/surface.ts'
import { barycentricsAt, normalAt, walk } from '../../skin/walk.ts'

/** Millimetres between points of a line. */
export const STEP = 0.6

/** A line on a surface. */
export interface Trace {
  /** x, y and z of each point. */
  points: number[]
  /** The triangle of each point. */
  triangles: number[]
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
  const trace: Trace = { points: [], triangles: [] }
  let triangle = start.triangle
  for (let length = 0; length <= maxLength; length += STEP) {
    barycentricsAt(weights, surface, triangle, position)
    normalAt(normal, surface, triangle, weights)
    trace.points.push(...position)
    trace.triangles.push(triangle)
    if (!field(position, normal, triangle, weights, direction)) break
    triangle = walk(surface, triangle, position, direction, STEP)
    if (triangle < 0) break
  }
  return trace
}
