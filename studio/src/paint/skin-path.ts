import { crossOf, dot, type SkinSurface } from 'furrow/internal'
import type { SkinPoint } from './paint-skin.ts'
import { cross, distanceBetween } from './vectors.ts'

/** Longest path: `MAX_DETOUR` times the straight distance plus `MAX_DETOUR_OFFSET` mm. Longer ones are detours, for example into the mouth. */
const MAX_DETOUR = 2
const MAX_DETOUR_OFFSET = 1
/** Fraction by which each end is moved towards the centroid of its triangle, so that the plane of the path intersects the triangle. */
const INWARDS = 1e-6

/**
 * Finds the path over a skin between two points: the intersection of the skin with a plane. The plane contains both points and is parallel to
 * the mean of their normals.
 *
 * @returns both ends and, between them, the intersections with edges. Undefined if no such path connects the ends, or if it is too long.
 */
export function skinPath(surface: SkinSurface, from: SkinPoint, to: SkinPoint): SkinPoint[] | undefined {
  const { adjacent, corners, points } = surface
  const [start, end] = [moveInwards(surface, from), moveInwards(surface, to)]
  const up = normalOf(surface, from.triangle)
  for (const [k, value] of normalOf(surface, to.triangle).entries()) up[k] += value
  const left = cross(
    up,
    start.map((value, k) => end[k] - value),
  )
  const middle = dot(start, left)
  const offsetOf = (corner: number) => dot(points.subarray(3 * corner, 3 * corner + 3), left) - middle

  const path = [from]
  let { triangle } = from
  let most = MAX_DETOUR * distanceBetween(from.position, to.position) + MAX_DETOUR_OFFSET
  while (triangle !== to.triangle) {
    // Corners are in counterclockwise order. The path leaves the triangle across the edge that begins on the right of the path and ends on its left.
    const offsets = [0, 1, 2].map((k) => offsetOf(corners[3 * triangle + k]))
    const edge = [0, 1, 2].findIndex((k) => offsets[k] < 0 && offsets[(k + 1) % 3] >= 0)
    if (edge < 0) return undefined
    const [a, b] = [corners[3 * triangle + edge], corners[3 * triangle + ((edge + 1) % 3)]]
    const t = offsets[edge] / (offsets[edge] - offsets[(edge + 1) % 3])
    const [x, y, z] = [0, 1, 2].map((k) => points[3 * a + k] + t * (points[3 * b + k] - points[3 * a + k]))
    triangle = adjacent[3 * triangle + edge]
    most -= distanceBetween(path[path.length - 1].position, [x, y, z])
    if (triangle < 0 || most < 0) return undefined
    path.push({ triangle, position: [x, y, z] })
  }
  return [...path, to]
}

function moveInwards({ points, corners }: SkinSurface, { triangle, position }: SkinPoint): Float64Array {
  return Float64Array.from(position, (value, k) => {
    let middle = 0
    for (let i = 0; i < 3; i++) middle += points[3 * corners[3 * triangle + i] + k] / 3
    return value + INWARDS * (middle - value)
  })
}

function normalOf({ points, corners }: SkinSurface, triangle: number): Float64Array {
  const normal = new Float64Array(3)
  const [a, b, c] = corners.subarray(3 * triangle, 3 * triangle + 3)
  const length = crossOf(points, a, b, c, normal)
  return normal.map((value) => value / length)
}
