import { triangleNormal } from '../../math/triangle.ts'
import { length, normalize } from '../../math/vector.ts'
import { weldVertices } from '../../math/weld.ts'

/** A skin at rest and what deforms it. Nothing is changed or kept. */
export interface Skin {
  /** x, y and z of each vertex, y up, in metres; of a face in any unit. */
  positions: ArrayLike<number>
  /** u and v of each vertex, v = 0 at the top. */
  uvs: ArrayLike<number>
  /** Three vertices per triangle. */
  indices: ArrayLike<number>
  targets: readonly SkinTarget[]
}

/** A blendshape. */
export interface SkinTarget {
  name: string
  /** x, y and z added to each vertex at weight 1. */
  offsets: ArrayLike<number>
}

/** A skin as one welded surface: vertices at the same position are one point, so that UV seams are not borders of the surface. */
export interface SkinSurface {
  /** x, y and z of each point. */
  points: Float64Array
  /** Unit normals of the points: means over the triangles around them, weighted by area. */
  normals: Float64Array
  /** Area of each point: a third of that of its triangles. */
  areas: Float64Array
  /** Three points per triangle; degenerate triangles are left out. */
  corners: Uint32Array
  /** For each triangle its index in the skin. */
  skinTriangles: Uint32Array
  /** For each vertex of the skin its point. */
  pointOf: Uint32Array
  /** The triangle across each edge, at 3 t + k for the edge from corner k of triangle t to the next; -1 at a border. */
  adjacent: Int32Array
  /** Neighbours of point p: `neighbours` from `neighbourStarts[p]` to `neighbourStarts[p + 1]`. */
  neighbourStarts: Uint32Array
  neighbours: Uint32Array
}

/** A point of a surface. */
export interface SurfacePoint {
  triangle: number
  position: [x: number, y: number, z: number]
}

/** Welds a skin into one surface. */
export function weldSurface({ positions, indices }: Pick<Skin, 'positions' | 'indices'>): SkinSurface {
  const { pointOf, points } = weldPoints(positions)
  const corners: number[] = []
  const skinTriangles: number[] = []
  const normals = new Float64Array(points.length)
  const normal = new Float64Array(3)
  for (let t = 0; 3 * t + 2 < indices.length; t++) {
    const triangle = [0, 1, 2].map((k) => pointOf[indices[3 * t + k]])
    const [a, b, c] = triangle
    if (!(crossOf(points, a, b, c, normal) > 0) || a === b || b === c || a === c) continue
    corners.push(a, b, c)
    skinTriangles.push(t)
    for (const point of triangle) {
      for (let k = 0; k < 3; k++) normals[3 * point + k] += normal[k]
    }
  }
  for (let i = 0; i < normals.length; i += 3) normalize(normals, i)
  const welded = Uint32Array.from(corners)
  return {
    points,
    normals,
    areas: pointAreas(points, welded),
    corners: welded,
    skinTriangles: Uint32Array.from(skinTriangles),
    pointOf,
    adjacent: adjacentTriangles(welded),
    ...pointNeighbours(welded, points.length / 3),
  }
}

/** Area of each point: a third of that of the triangles around it. */
export function pointAreas(points: ArrayLike<number>, corners: Uint32Array): Float64Array {
  const areas = new Float64Array(points.length / 3)
  const normal = new Float64Array(3)
  for (let t = 0; t < corners.length; t += 3) {
    const doubleArea = crossOf(points, corners[t], corners[t + 1], corners[t + 2], normal)
    for (let k = 0; k < 3; k++) areas[corners[t + k]] += doubleArea / 6
  }
  return areas
}

/** Offsets of a target by point; those that are NaN count as 0. */
export function pointOffsets({ points, pointOf }: SkinSurface, { offsets }: SkinTarget): Float64Array {
  const out = new Float64Array(points.length)
  for (const [vertex, point] of pointOf.entries()) {
    for (let k = 0; k < 3; k++) out[3 * point + k] = offsets[3 * vertex + k] || 0
  }
  return out
}

/** The three points of a triangle. */
export function cornersOf({ corners }: SkinSurface, triangle: number): [number, number, number] {
  return [corners[3 * triangle], corners[3 * triangle + 1], corners[3 * triangle + 2]]
}

/** The skin's three vertices of a triangle of its surface. */
export function skinVertices(
  { indices }: Pick<Skin, 'indices'>,
  { skinTriangles }: SkinSurface,
  triangle: number,
): [number, number, number] {
  const first = 3 * skinTriangles[triangle]
  return [indices[first], indices[first + 1], indices[first + 2]]
}

/**
 * The normal of a triangle, not normalised: the cross product of its edges.
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
  triangleNormal(out, points, a, b, c)
  return length(out)
}

function weldPoints(positions: ArrayLike<number>) {
  const { pointOf, count } = weldVertices(positions)
  const points = new Float64Array(3 * count)
  for (const [vertex, point] of pointOf.entries()) {
    for (let k = 0; k < 3; k++) points[3 * point + k] = positions[3 * vertex + k]
  }
  return { pointOf, points }
}

/** More points than triangles can have; a pair of points then makes one whole number below 2^53. */
const MAX_POINTS = 2 ** 26

function adjacentTriangles(corners: Uint32Array): Int32Array {
  const edges = new Map<number, number>()
  const adjacent = new Int32Array(corners.length).fill(-1)
  for (let t = 0; t < corners.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const [from, to] = [corners[t + k], corners[t + ((k + 1) % 3)]]
      const opposite = edges.get(to * MAX_POINTS + from)
      edges.set(from * MAX_POINTS + to, t + k)
      if (opposite === undefined) continue
      adjacent[t + k] = Math.floor(opposite / 3)
      adjacent[opposite] = t / 3
    }
  }
  return adjacent
}

function pointNeighbours(corners: Uint32Array, count: number) {
  const sets: Set<number>[] = Array.from({ length: count }, () => new Set())
  for (let t = 0; t < corners.length; t += 3) {
    const [a, b, c] = [corners[t], corners[t + 1], corners[t + 2]]
    sets[a].add(b).add(c)
    sets[b].add(a).add(c)
    sets[c].add(a).add(b)
  }
  const neighbourStarts = new Uint32Array(count + 1)
  for (const [i, set] of sets.entries()) neighbourStarts[i + 1] = neighbourStarts[i] + set.size
  return { neighbourStarts, neighbours: Uint32Array.from(sets.flatMap((set) => [...set])) }
}
