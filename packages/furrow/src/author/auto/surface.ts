import { weldVertices } from '../../math/weld.ts'

/** A skin at rest with what can move it. Nothing is changed or kept. */
export interface Skin {
  /** x, y and z of each vertex, y upwards, in any unit. */
  positions: ArrayLike<number>
  /** u and v of each vertex, v = 0 at the top. */
  uvs: ArrayLike<number>
  /** Three vertices for each triangle. */
  indices: ArrayLike<number>
  targets: readonly SkinTarget[]
}

/** A blendshape. */
export interface SkinTarget {
  name: string
  /** x, y and z that it adds to each vertex at weight 1. */
  offsets: ArrayLike<number>
}

/** A skin as one surface: vertices at one place are one point, so that seams of the texture are none of its own. */
export interface Surface {
  /** x, y and z of each point. */
  points: Float64Array
  /** Of length 1, the mean of the triangles round a point by their areas. */
  normals: Float64Array
  /** Surface that belongs to each point: a third of its triangles. */
  areas: Float64Array
  /** Three points for each triangle; triangles without surface are left out. */
  corners: Uint32Array
  /** For each triangle its number in the skin. */
  triangleOf: Uint32Array
  /** For each vertex of the skin its point. */
  pointOf: Uint32Array
  /** For each edge k of triangle t, from corner k to the next, the triangle beyond it at 3 t + k, or -1. */
  beyond: Int32Array
  /** Neighbours of point p: `neighbours` from `starts[p]` to `starts[p + 1]`. */
  starts: Uint32Array
  neighbours: Uint32Array
}

/** Joins a skin into one surface. */
export function joinSurface({ positions, indices }: Pick<Skin, 'positions' | 'indices'>): Surface {
  const { pointOf, points } = joinPoints(positions)
  const corners: number[] = []
  const triangleOf: number[] = []
  const normals = new Float64Array(points.length)
  const normal = new Float64Array(3)
  for (let t = 0; 3 * t + 2 < indices.length; t++) {
    const [a, b, c] = [0, 1, 2].map((k) => pointOf[indices[3 * t + k]!]!) as [number, number, number]
    const doubled = crossOf(points, a, b, c, normal)
    if (!(doubled > 0) || a === b || b === c || a === c) continue
    corners.push(a, b, c)
    triangleOf.push(t)
    for (const i of [a, b, c]) {
      for (let k = 0; k < 3; k++) normals[3 * i + k]! += normal[k]!
    }
  }
  for (let i = 0; i < normals.length / 3; i++) {
    const length = Math.hypot(normals[3 * i]!, normals[3 * i + 1]!, normals[3 * i + 2]!) || 1
    for (let k = 0; k < 3; k++) normals[3 * i + k]! /= length
  }
  const joined = Uint32Array.from(corners)
  return {
    points,
    normals,
    areas: pointAreas(points, joined),
    corners: joined,
    triangleOf: Uint32Array.from(triangleOf),
    pointOf,
    beyond: trianglesBeyond(joined),
    ...neighboursOf(joined, points.length / 3),
  }
}

/** Surface that belongs to each point. */
export function pointAreas(points: ArrayLike<number>, corners: Uint32Array): Float64Array {
  const areas = new Float64Array(points.length / 3)
  const normal = new Float64Array(3)
  for (let t = 0; t < corners.length; t += 3) {
    const doubled = crossOf(points, corners[t]!, corners[t + 1]!, corners[t + 2]!, normal)
    for (let k = 0; k < 3; k++) areas[corners[t + k]!]! += doubled / 6
  }
  return areas
}

/** What a target moves, by points. */
export function pointOffsets(surface: Surface, { offsets }: SkinTarget): Float64Array {
  const out = new Float64Array(surface.points.length)
  for (const [vertex, point] of surface.pointOf.entries()) {
    for (let k = 0; k < 3; k++) out[3 * point + k] = offsets[3 * vertex + k]! || 0
  }
  return out
}

/**
 * The cross product of two edges of a triangle, along its normal.
 *
 * @param points x, y and z of each.
 * @param a first corner; the corners are counterclockwise as seen from outside.
 * @param b second corner.
 * @param c third corner.
 * @param out takes x, y and z.
 * @returns its length, twice the triangle's area.
 */
export function crossOf(
  points: ArrayLike<number>,
  a: number,
  b: number,
  c: number,
  out: Float64Array,
): number {
  const ux = points[3 * b]! - points[3 * a]!
  const uy = points[3 * b + 1]! - points[3 * a + 1]!
  const uz = points[3 * b + 2]! - points[3 * a + 2]!
  const vx = points[3 * c]! - points[3 * a]!
  const vy = points[3 * c + 1]! - points[3 * a + 1]!
  const vz = points[3 * c + 2]! - points[3 * a + 2]!
  out[0] = uy * vz - uz * vy
  out[1] = uz * vx - ux * vz
  out[2] = ux * vy - uy * vx
  return Math.hypot(out[0]!, out[1]!, out[2]!)
}

function joinPoints(positions: ArrayLike<number>) {
  const { pointOf, count } = weldVertices(positions)
  const points = new Float64Array(3 * count)
  for (const [vertex, point] of pointOf.entries()) {
    for (let k = 0; k < 3; k++) points[3 * point + k] = positions[3 * vertex + k]!
  }
  return { pointOf, points }
}

/** More than triangles can have; a pair of points below it is one whole number below 2^53. */
const MOST_POINTS = 2 ** 26

function trianglesBeyond(corners: Uint32Array): Int32Array {
  const count = corners.length
  const edges = new Map<number, number>()
  const beyond = new Int32Array(count).fill(-1)
  for (let t = 0; t < count; t += 3) {
    for (let k = 0; k < 3; k++) {
      const [from, to] = [corners[t + k]!, corners[t + ((k + 1) % 3)]!]
      const other = edges.get(to * MOST_POINTS + from)
      edges.set(from * MOST_POINTS + to, t + k)
      if (other === undefined) continue
      beyond[t + k] = Math.floor(other / 3)
      beyond[other] = t / 3
    }
  }
  return beyond
}

function neighboursOf(corners: Uint32Array, count: number) {
  const sets: Set<number>[] = Array.from({ length: count }, () => new Set())
  for (let t = 0; t < corners.length; t += 3) {
    const [a, b, c] = [corners[t]!, corners[t + 1]!, corners[t + 2]!]
    sets[a]!.add(b).add(c)
    sets[b]!.add(a).add(c)
    sets[c]!.add(a).add(b)
  }
  const starts = new Uint32Array(count + 1)
  for (const [i, set] of sets.entries()) starts[i + 1] = starts[i]! + set.size
  return { starts, neighbours: Uint32Array.from(sets.flatMap((set) => [...set])) }
}
