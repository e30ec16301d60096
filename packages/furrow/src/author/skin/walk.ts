import { barycentrics3, interpolate } from '../../math/barycentrics.ts'
import { triangleNormal } from '../../math/triangle.ts'
import { dot, normalize } from '../../math/vector.ts'
import { cornersOf, type SkinSurface } from './surface.ts'

/** Fraction of the distance to a triangle's centroid by which `pullInwards` moves a position. */
const INWARDS = 1e-3
/** Maximum number of triangles that a call of `walk` crosses. */
const MAX_CROSSED = 8

/** Scratch: barycentric coordinates of a step's start and end, and its end position. Reused because `walk` is called often. */
const [here, there, target] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)]

/**
 * Moves a position over a surface, projecting the direction onto each triangle crossed.
 *
 * @param start triangle that contains the position.
 * @param position changed in place.
 * @param distance distance to move, in the unit of the surface. The walk stops early when it has crossed `MAX_CROSSED` triangles.
 * @returns the final triangle, or -1 at the surface's border.
 */
export function walk(
  surface: SkinSurface,
  start: number,
  position: Float64Array,
  direction: ArrayLike<number>,
  distance: number,
): number {
  let triangle = start
  let left = distance
  for (let crossed = 0; crossed < MAX_CROSSED; crossed++) {
    projectOntoTriangle(target, surface, triangle, direction)
    for (let k = 0; k < 3; k++) target[k] = position[k] + left * target[k]
    barycentricsAt(here, surface, triangle, position)
    barycentricsAt(there, surface, triangle, target)
    // Find the first edge that the step crosses, and the fraction of the step before the crossing.
    let fraction = 1
    let edge = -1
    for (let k = 0; k < 3; k++) {
      if (there[k] >= 0) continue
      const crossing = Math.max(here[k], 0) / (Math.max(here[k], 0) - there[k])
      if (crossing >= fraction && edge >= 0) continue
      fraction = crossing
      edge = (k + 1) % 3
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

/** Computes the barycentric coordinates of a position in a triangle. */
export function barycentricsAt(
  out: Float64Array,
  surface: SkinSurface,
  triangle: number,
  position: ArrayLike<number>,
): void {
  const [a, b, c] = cornersOf(surface, triangle)
  barycentrics3(out, surface.points, a, b, c, position)
}

/** Computes the position at barycentric coordinates of a triangle. */
export function positionAt(
  out: Float64Array,
  surface: SkinSurface,
  triangle: number,
  weights: Float64Array,
): void {
  const [a, b, c] = cornersOf(surface, triangle)
  interpolate(out, surface.points, 3, a, b, c, weights[0], weights[1], weights[2])
}

/** Computes the unit normal at barycentric coordinates of a triangle. Negative coordinates count as 0. */
export function normalAt(
  out: Float64Array,
  surface: SkinSurface,
  triangle: number,
  weights: Float64Array,
): void {
  const [a, b, c] = cornersOf(surface, triangle)
  const [wa, wb, wc] = [Math.max(weights[0], 0), Math.max(weights[1], 0), Math.max(weights[2], 0)]
  interpolate(out, surface.normals, 3, a, b, c, wa, wb, wc)
  normalize(out)
}

/** Moves a position slightly towards a triangle's centroid. Otherwise, a walk along an edge could alternate between two triangles. */
function pullInwards(surface: SkinSurface, triangle: number, position: Float64Array): void {
  const corners = cornersOf(surface, triangle)
  for (let k = 0; k < 3; k++) {
    let middle = 0
    for (const point of corners) middle += surface.points[3 * point + k] / 3
    position[k] += INWARDS * (middle - position[k])
  }
}

function projectOntoTriangle(
  out: Float64Array,
  surface: SkinSurface,
  triangle: number,
  direction: ArrayLike<number>,
): void {
  const [a, b, c] = cornersOf(surface, triangle)
  triangleNormal(out, surface.points, a, b, c)
  const rise = dot(out, direction) / dot(out, out)
  for (let k = 0; k < 3; k++) out[k] = direction[k] - rise * out[k]
  normalize(out)
}
