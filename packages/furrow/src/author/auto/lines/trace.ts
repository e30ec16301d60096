import type { SkinSurface, SurfacePoint } from '../../skin/surface.ts'
import { barycentricsAt, normalAt, walk } from '../../skin/walk.ts'

/** Distance between points of a line in millimetres. */
export const STEP = 0.6

/** Line on a surface. */
export interface Trace {
  /** Packed xyz. */
  points: number[]
  triangles: number[]
}

/**
 * Chooses the direction in which a line continues.
 *
 * @param position end of the line so far.
 * @param normal normal of the surface at the position.
 * @param triangle triangle that contains the position.
 * @param barycentrics barycentric coordinates of the position in the triangle.
 * @param out receives x, y and z of the direction.
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
 * Traces a line over a surface until `field` returns false, or the line reaches the border of the surface.
 *
 * @param maxLength maximum length of the line in millimetres.
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
