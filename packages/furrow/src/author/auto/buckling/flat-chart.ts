import { barycentrics2, interpolate } from '../../../math/barycentrics.ts'
import { cornersOf, type SkinSurface, type SurfacePoint } from '../../skin/surface.ts'
import { flatten } from './flatten.ts'

/** Maximum number of triangles that `liftPoint` crosses. */
const MAX_CROSSED = 256
/** Barycentric tolerance for positions inside a triangle. */
const TOLERANCE = 1e-9

/** Region of a surface, flattened with little distortion of lengths. */
export interface FlatChart {
  surface: SkinSurface
  /** Indices of the region's points in the surface. */
  points: Uint32Array
  /** Indices of the region's triangles in the surface. */
  triangles: Uint32Array
  /** For each triangle of the surface, its index in `triangles`; -1 outside the region. */
  indexOf: Int32Array
  /** Three indices into `points` per triangle. */
  corners: Uint32Array
  /** Packed x, y per point, in the unit of the surface. */
  flat: Float64Array
}

/**
 * Flattens a region of a surface.
 *
 * @param isInside returns whether a point belongs to the region. Only the connected part with the most triangles is flattened.
 * @param initial returns the approximate flat position of a point. The flattened region has the orientation of these positions.
 * @returns undefined if the region has no triangles.
 */
export function flatChart(
  surface: SkinSurface,
  isInside: (point: number) => boolean,
  initial: (point: number) => readonly [x: number, y: number],
): FlatChart | undefined {
  const chart = placedChart(surface, largestPart(surface, isInside), initial)
  return chart && { ...chart, flat: flatten(surface.points, chart.points, chart.corners, chart.flat) }
}

/**
 * Lays triangles of a surface out in a plane, without flattening them.
 *
 * @param place returns the flat position of a point.
 * @returns undefined if there are no triangles.
 */
export function placedChart(
  surface: SkinSurface,
  triangles: Uint32Array,
  place: (point: number) => readonly [x: number, y: number],
): FlatChart | undefined {
  if (triangles.length === 0) return undefined
  const indexOf = new Int32Array(surface.skinTriangles.length).fill(-1)
  const pointIndex = new Map<number, number>()
  const corners = new Uint32Array(3 * triangles.length)
  for (const [index, triangle] of triangles.entries()) {
    indexOf[triangle] = index
    for (const [k, point] of cornersOf(surface, triangle).entries()) {
      const known = pointIndex.get(point) ?? pointIndex.size
      pointIndex.set(point, known)
      corners[3 * index + k] = known
    }
  }
  const points = Uint32Array.from(pointIndex.keys())
  const flat = Float64Array.from([...points].flatMap((point) => [...place(point)]))
  return { surface, points, triangles, indexOf, corners, flat }
}

/**
 * Finds the point of the surface at a flat position by walking from a nearby triangle.
 *
 * @param start index of a triangle of the chart.
 * @returns the point, and the index of its triangle in the chart; undefined if the walk leaves the chart or crosses `MAX_CROSSED` triangles.
 */
export function liftPoint(
  chart: FlatChart,
  start: number,
  x: number,
  y: number,
): { index: number; point: SurfacePoint } | undefined {
  const { surface, triangles, indexOf, corners } = chart
  const weights = new Float64Array(3)
  let index = start
  for (let crossed = 0; crossed < MAX_CROSSED; crossed++) {
    barycentrics2(weights, flatTriangle(chart, index), x, y)
    const lowest =
      weights[0] < weights[1] ? (weights[0] < weights[2] ? 0 : 2) : weights[1] < weights[2] ? 1 : 2
    if (weights[lowest] >= -TOLERANCE) {
      const position = new Float64Array(3)
      const [a, b, c] = [0, 1, 2].map((k) => chart.points[corners[3 * index + k]])
      interpolate(position, surface.points, 3, a, b, c, weights[0], weights[1], weights[2])
      const triangle = triangles[index]
      return { index, point: { triangle, position: [position[0], position[1], position[2]] } }
    }
    const next = surface.adjacent[3 * triangles[index] + ((lowest + 1) % 3)]
    if (next < 0 || indexOf[next] < 0) return undefined
    index = indexOf[next]
  }
  return undefined
}

/** Returns x and y of a triangle's three flat corners. */
export function flatTriangle({ corners, flat }: FlatChart, index: number): Float64Array {
  const out = new Float64Array(6)
  for (let k = 0; k < 3; k++) {
    out[2 * k] = flat[2 * corners[3 * index + k]]
    out[2 * k + 1] = flat[2 * corners[3 * index + k] + 1]
  }
  return out
}

/** Returns the triangles of the region's largest connected part. */
function largestPart(surface: SkinSurface, isInside: (point: number) => boolean): Uint32Array {
  const inside = Uint8Array.from(surface.areas, (_, point) => (isInside(point) ? 1 : 0))
  const isOpen = Uint8Array.from(surface.skinTriangles, (_, triangle) =>
    cornersOf(surface, triangle).every((point) => inside[point]) ? 1 : 0,
  )
  let largest: number[] = []
  for (let first = 0; first < isOpen.length; first++) {
    if (!isOpen[first]) continue
    const part = [first]
    isOpen[first] = 0
    for (let i = 0; i < part.length; i++) {
      for (const next of surface.adjacent.subarray(3 * part[i], 3 * part[i] + 3)) {
        if (next < 0 || !isOpen[next]) continue
        isOpen[next] = 0
        part.push(next)
      }
    }
    if (part.length > largest.length) largest = part
  }
  return Uint32Array.from(largest)
}
