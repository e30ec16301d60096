import { triangleNormal } from '../../math/triangle.ts'
import { length, normalize } from '../../math/vector.ts'
import { weldVertices } from '../../math/weld.ts'
import type { SkinSkeleton } from './skeleton.ts'

/**
 * Mesh of the skin in the rest pose, and its blendshapes. Functions that take a `Skin` do not change its arrays. Public
 * functions (`furrow/author`) also do not keep these arrays.
 */
export interface Skin {
  /** Packed xyz per vertex, y up, in metres. If `autoWrinkles` finds the eyes, any unit works, because it scales the skin by their distance. */
  positions: ArrayLike<number>
  /** Packed uv per vertex, v = 0 at the top. */
  uvs: ArrayLike<number>
  /** Three vertices per triangle. */
  indices: ArrayLike<number>
  targets: readonly SkinTarget[]
  /** Skinning weight of each vertex for the head joint, 0..1; undefined if the character has no head joint. */
  headWeights?: ArrayLike<number> | undefined
  /** Skeleton that moves the skin; undefined if no joints move it. */
  skeleton?: SkinSkeleton | undefined
}

/** Blendshape of a skin. */
export interface SkinTarget {
  name: string
  /** Name of a VRM expression that moves only this target. */
  expression?: string | undefined
  /**
   * ARKit name that the user assigned; `null` if the user said that the target matches no ARKit shape. Overrides recognition by motion and
   * name. The name has no `Left` or `Right` if the target moves both sides of the face.
   */
  correction?: string | null | undefined
  /** Packed xyz added to the vertices at weight 1. */
  offsets: ArrayLike<number>
}

/** Surface of a skin. Vertices at the same position are merged to one point, so UV seams are not borders. */
export interface SkinSurface {
  /** Packed xyz per point. */
  points: Float64Array
  /** Unit normals of the points: area-weighted means of the adjacent triangles. */
  normals: Float64Array
  /** Area of each point: a third of the area of its triangles. */
  areas: Float64Array
  /** Three points per triangle. Degenerate triangles of the skin are left out. */
  corners: Uint32Array
  /** For each triangle of the surface, its index in the skin. */
  skinTriangles: Uint32Array
  /** Point of the surface for each vertex of the skin. */
  pointOf: Uint32Array
  /** Triangle across each edge, -1 at a border. Index `3 * t + k` is the edge from corner k of triangle t to the next corner. */
  adjacent: Int32Array
  /** Start of each point's neighbours in `neighbours`. The neighbours of point p end before index `neighbourStarts[p + 1]`. */
  neighbourStarts: Uint32Array
  neighbours: Uint32Array
}

export interface SurfacePoint {
  triangle: number
  position: [x: number, y: number, z: number]
}

/** Builds a surface from a skin by merging vertices with equal positions. */
export function weldSurface({ positions, indices }: Pick<Skin, 'positions' | 'indices'>): SkinSurface {
  const { pointOf, points } = weldPoints(positions)
  const corners = new Uint32Array(indices.length)
  const skinTriangles = new Uint32Array(Math.floor(indices.length / 3))
  const normals = new Float64Array(points.length)
  const normal = new Float64Array(3)
  let count = 0
  for (let t = 0; t < skinTriangles.length; t++) {
    const a = pointOf[indices[3 * t]]
    const b = pointOf[indices[3 * t + 1]]
    const c = pointOf[indices[3 * t + 2]]
    if (!(crossOf(points, a, b, c, normal) > 0) || a === b || b === c || a === c) continue
    corners[3 * count] = a
    corners[3 * count + 1] = b
    corners[3 * count + 2] = c
    skinTriangles[count++] = t
    for (let k = 0; k < 3; k++) {
      normals[3 * a + k] += normal[k]
      normals[3 * b + k] += normal[k]
      normals[3 * c + k] += normal[k]
    }
  }
  for (let i = 0; i < normals.length; i += 3) normalize(normals, i)
  const welded = corners.slice(0, 3 * count)
  return {
    points,
    normals,
    areas: pointAreas(points, welded),
    corners: welded,
    skinTriangles: skinTriangles.slice(0, count),
    pointOf,
    adjacent: adjacentTriangles(welded, points.length / 3),
    ...pointNeighbours(welded, points.length / 3),
  }
}

/** Computes the area of each point: a third of the area of its triangles. */
export function pointAreas(points: ArrayLike<number>, corners: Uint32Array): Float64Array {
  const areas = new Float64Array(points.length / 3)
  const normal = new Float64Array(3)
  for (let t = 0; t < corners.length; t += 3) {
    const doubleArea = crossOf(points, corners[t], corners[t + 1], corners[t + 2], normal)
    for (let k = 0; k < 3; k++) areas[corners[t + k]] += doubleArea / 6
  }
  return areas
}

/** Converts a target's offsets per vertex to offsets per point. NaN becomes 0. */
export function pointOffsets({ points, pointOf }: SkinSurface, { offsets }: SkinTarget): Float64Array {
  const out = new Float64Array(points.length)
  for (let vertex = 0; vertex < pointOf.length; vertex++) {
    for (let k = 0; k < 3; k++) out[3 * pointOf[vertex] + k] = offsets[3 * vertex + k] || 0
  }
  return out
}

export function cornersOf({ corners }: SkinSurface, triangle: number): [number, number, number] {
  return [corners[3 * triangle], corners[3 * triangle + 1], corners[3 * triangle + 2]]
}

/** Computes the bounding box of a triangle: its lowest and highest x, y and z. */
export function triangleBox(
  { points, corners }: SkinSurface,
  triangle: number,
  low: Float64Array,
  high: Float64Array,
): void {
  const a = 3 * corners[3 * triangle]
  const b = 3 * corners[3 * triangle + 1]
  const c = 3 * corners[3 * triangle + 2]
  for (let k = 0; k < 3; k++) {
    low[k] = Math.min(points[a + k], points[b + k], points[c + k])
    high[k] = Math.max(points[a + k], points[b + k], points[c + k])
  }
}

/** Returns the three vertices that a triangle of the surface has in the skin. */
export function skinVertices(
  { indices }: Pick<Skin, 'indices'>,
  { skinTriangles }: SkinSurface,
  triangle: number,
): [number, number, number] {
  const first = 3 * skinTriangles[triangle]
  return [indices[first], indices[first + 1], indices[first + 2]]
}

/**
 * Computes the normal of a triangle, not normalised: the cross product of its edges.
 *
 * @param points packed xyz.
 * @param a first corner; corners are counterclockwise as seen from outside.
 * @param b second corner.
 * @param c third corner.
 * @param out receives x, y and z.
 * @returns length of the normal, which is twice the triangle's area.
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

/** Returns the area of all triangles, in the square of the unit of the positions. */
export function surfaceArea(positions: ArrayLike<number>, indices: ArrayLike<number>): number {
  const normal = new Float64Array(3)
  let sum = 0
  for (let t = 0; t + 2 < indices.length; t += 3) {
    sum += crossOf(positions, indices[t], indices[t + 1], indices[t + 2], normal) / 2
  }
  return sum
}

function weldPoints(positions: ArrayLike<number>) {
  const { pointOf, count } = weldVertices(positions)
  const points = new Float64Array(3 * count)
  for (let vertex = 0; vertex < pointOf.length; vertex++) {
    for (let k = 0; k < 3; k++) points[3 * pointOf[vertex] + k] = positions[3 * vertex + k]
  }
  return { pointOf, points }
}

/**
 * Finds the triangle across each half-edge. The half-edges are sorted by undirected edge, so that opposite half-edges are adjacent in the
 * list. If more than two triangles share an edge, their half-edges are paired in the order of the list.
 */
function adjacentTriangles(corners: Uint32Array, count: number): Int32Array {
  const from = corners
  const to = corners.map((_, i) => corners[i % 3 === 2 ? i - 2 : i + 1])
  let order: Uint32Array = corners.map((_, i) => i)
  order = sortedBy(order, (i) => Math.min(from[i], to[i]), count)
  order = sortedBy(order, (i) => Math.max(from[i], to[i]), count)
  const adjacent = new Int32Array(corners.length).fill(-1)
  /** For the current edge, the last half-edge towards the higher point index (`up`) and the last towards the lower one (`down`); -1 if none. */
  let [up, down] = [-1, -1]
  for (let n = 0; n < order.length; n++) {
    const i = order[n]
    const before = order[n - 1]
    const isSame =
      n > 0 &&
      ((from[i] === from[before] && to[i] === to[before]) ||
        (from[i] === to[before] && to[i] === from[before]))
    if (!isSame) [up, down] = [-1, -1]
    const opposite = from[i] < to[i] ? down : up
    if (from[i] < to[i]) up = i
    else down = i
    if (opposite < 0) continue
    adjacent[i] = Math.floor(opposite / 3)
    adjacent[opposite] = Math.floor(i / 3)
  }
  return adjacent
}

/** Sorts stably by integers below `count` (counting sort). */
function sortedBy(items: Uint32Array, keyOf: (item: number) => number, count: number): Uint32Array {
  const ends = new Uint32Array(count + 1)
  for (let i = 0; i < items.length; i++) ends[keyOf(items[i]) + 1]++
  for (let key = 0; key < count; key++) ends[key + 1] += ends[key]
  const out = new Uint32Array(items.length)
  for (let i = 0; i < items.length; i++) out[ends[keyOf(items[i])]++] = items[i]
  return out
}

/** Returns the neighbours of each point in triangle order. */
function pointNeighbours(corners: Uint32Array, count: number) {
  const starts = new Uint32Array(count + 1)
  for (let i = 0; i < corners.length; i++) starts[corners[i] + 1] += 2
  for (let point = 0; point < count; point++) starts[point + 1] += starts[point]
  /** Neighbours with duplicates: each shared edge appears twice. */
  const named = new Uint32Array(2 * corners.length)
  const ends = starts.slice()
  for (let t = 0; t < corners.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const point = corners[t + k]
      for (let n = 0; n < 3; n++) if (n !== k) named[ends[point]++] = corners[t + n]
    }
  }
  const neighbours = new Uint32Array(named.length)
  const neighbourStarts = new Uint32Array(count + 1)
  /** For each point, 1 plus the index of the last point that listed it as a neighbour. Serves to skip duplicates. */
  const lastOf = new Uint32Array(count)
  let end = 0
  for (let point = 0; point < count; point++) {
    for (let i = starts[point]; i < starts[point + 1]; i++) {
      if (lastOf[named[i]] === point + 1) continue
      lastOf[named[i]] = point + 1
      neighbours[end++] = named[i]
    }
    neighbourStarts[point + 1] = end
  }
  return { neighbourStarts, neighbours: neighbours.slice(0, end) }
}
