import { crossOf, dot, type SkinSurface } from 'furrow/internal'
import type { SkinPoint } from './paint-skin.ts'
import { crossed, distanceBetween } from './vectors.ts'

/** A path longer than this many times the straight way, and some millimetres, has lost its way: it went into the mouth, say. */
const MOST_DETOUR = 2
const DETOUR = 1
/** Fraction of the way to its triangle's centroid that an end is moved: the plane of the path then crosses the triangle for certain. */
const INWARDS = 1e-6

/**
 * The way over a skin from one point to another, in the plane that goes through both and the mean of their normals: straight as seen from
 * above. Each part of it is the way between the ends of that part, so that it does not matter into how many a pointer cuts it.
 *
 * @returns its points, with both ends and where it crosses edges; undefined where the skin does not connect the ends on such a way.
 */
export function skinPath(surface: SkinSurface, from: SkinPoint, to: SkinPoint): SkinPoint[] | undefined {
  const { adjacent, corners, points } = surface
  const [start, end] = [inwards(surface, from), inwards(surface, to)]
  const up = normalOf(surface, from.triangle)
  for (const [k, value] of normalOf(surface, to.triangle).entries()) up[k] += value
  const left = crossed(
    up,
    start.map((value, k) => end[k] - value),
  )
  const middle = dot(start, left)
  const offsetOf = (corner: number) => dot(points.subarray(3 * corner, 3 * corner + 3), left) - middle

  const path = [from]
  let { triangle } = from
  let most = MOST_DETOUR * distanceBetween(from.position, to.position) + DETOUR
  while (triangle !== to.triangle) {
    // Corners go round counterclockwise: where they pass from the right to the left, the way leaves the triangle.
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

function inwards({ points, corners }: SkinSurface, { triangle, position }: SkinPoint): Float64Array {
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
