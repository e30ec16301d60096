import { cross } from '../../../math/vector.ts'
import { cornersOf, crossOf, type SkinSurface } from '../../skin/surface.ts'
import type { SkinLine } from '../../strokes/curve.ts'
import { LineGrid } from '../../strokes/line-grid.ts'
import type { SkinRegion } from '../anatomy/region.ts'
import { unroll } from '../surface/head-chart.ts'

/** Maximum number of triangles per region. Further triangles would hardly change the mean compression. */
const MAX_TRIANGLES = 10_000

/** Triangles near a region's lines. With them, `measureCompression` measures how much a pose shortens the skin across the lines. */
export interface Gauge {
  /** Three points per triangle. */
  corners: Uint32Array
  /**
   * For each triangle, the unit vector across the nearest line, stored as two factors. The first factor multiplies the edge from the first to
   * the second corner. The second factor multiplies the edge from the first to the third corner.
   */
  across: Float64Array
  /** Weight of each triangle in the mean compression. */
  weights: Float64Array
}

/**
 * Creates a gauge from the triangles within reach of a region's lines.
 *
 * @returns undefined if there are no such triangles.
 */
export function makeGauge(
  surface: SkinSurface,
  { reach, influence }: SkinRegion,
  lines: readonly SkinLine[],
): Gauge | undefined {
  const grid = new LineGrid(
    lines,
    lines.map(() => reach),
  )
  const { points, normals } = surface
  const near = trianglesNear(surface, grid)
  const every = Math.ceil(near.length / MAX_TRIANGLES)
  const [chosen, across, weights]: number[][] = [[], [], []]
  const [normal, perpendicular, centroid] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)]
  for (let i = 0; i < near.length; i += every) {
    const [a, b, c] = cornersOf(surface, near[i])
    centroidOf(surface, near[i], centroid)
    const [x, y, z] = centroid
    let [closest, line, segment] = [Infinity, -1, 0]
    grid.visit(centroid, normals.subarray(3 * a, 3 * a + 3), (found, distance, at) => {
      if (distance < closest) [closest, line, segment] = [distance, found, at]
    })
    if (line < 0) continue
    const regionWeight = influence?.(unroll(x, y, z)) ?? 1
    const weight = regionWeight * (1 - closest / reach) * crossOf(points, a, b, c, normal)
    if (!(weight > 0)) continue
    const p = lines[line].points
    const direction = [0, 1, 2].map((k) => p[3 * segment + 3 + k] - p[3 * segment + k])
    cross(perpendicular, normal, direction)
    const multiples = inEdges(points, a, b, c, perpendicular)
    if (!multiples) continue
    chosen.push(a, b, c)
    across.push(...multiples)
    weights.push(weight)
  }
  if (weights.length === 0) return undefined
  return {
    corners: Uint32Array.from(chosen),
    across: Float64Array.from(across),
    weights: Float64Array.from(weights),
  }
}

/** Returns the triangles whose centroids may be within reach of lines. */
function trianglesNear(surface: SkinSurface, grid: LineGrid): number[] {
  const centroid = new Float64Array(3)
  const near: number[] = []
  for (let triangle = 0; triangle < surface.skinTriangles.length; triangle++) {
    centroidOf(surface, triangle, centroid)
    if (grid.isNear(centroid, centroid)) near.push(triangle)
  }
  return near
}

function centroidOf({ points, corners }: SkinSurface, triangle: number, out: Float64Array): void {
  const a = 3 * corners[3 * triangle]
  const b = 3 * corners[3 * triangle + 1]
  const c = 3 * corners[3 * triangle + 2]
  for (let k = 0; k < 3; k++) out[k] = (points[a + k] + points[b + k] + points[c + k]) / 3
}

/** Normalises the vector v, which is in a triangle's plane. Returns it as factors on the edges from a to b and from a to c. */
function inEdges(points: ArrayLike<number>, a: number, b: number, c: number, v: ArrayLike<number>) {
  let [uu, uw, ww, uv, wv, vv] = [0, 0, 0, 0, 0, 0]
  for (let k = 0; k < 3; k++) {
    const u = points[3 * b + k] - points[3 * a + k]
    const w = points[3 * c + k] - points[3 * a + k]
    uu += u * u
    uw += u * w
    ww += w * w
    uv += u * v[k]
    wv += w * v[k]
    vv += v[k] * v[k]
  }
  const det = uu * ww - uw * uw
  const scale = 1 / Math.sqrt(vv)
  const multiples = [((ww * uv - uw * wv) / det) * scale, ((uu * wv - uw * uv) / det) * scale]
  return multiples.every(Number.isFinite) ? multiples : undefined
}

/**
 * Computes the vector across the nearest line for each triangle of a gauge (see `Gauge.across`). At rest, its length is 1.
 *
 * @param values packed xyz per point: positions, or the offsets of a target. For offsets, the result is the change of the vectors.
 * @param out receives x, y and z for each triangle of the gauge.
 */
export function vectorsAcross(
  { corners, across }: Gauge,
  values: ArrayLike<number>,
  out = new Float64Array(corners.length),
): Float64Array {
  for (let t = 0; t < corners.length; t += 3) {
    const a = 3 * corners[t]
    const b = 3 * corners[t + 1]
    const c = 3 * corners[t + 2]
    const along = across[(2 * t) / 3]
    const aside = across[(2 * t) / 3 + 1]
    for (let k = 0; k < 3; k++)
      out[t + k] = along * (values[b + k] - values[a + k]) + aside * (values[c + k] - values[a + k])
  }
  return out
}

/**
 * Returns the mean compression of the skin in a pose, as a fraction of its length across the lines. Stretched skin has a negative compression.
 *
 * @param rest result of `vectorsAcross` for the positions at rest.
 * @param moved for each target of the pose, its weight and the result of `vectorsAcross` for its offsets.
 */
export function measureCompression(
  { weights }: Gauge,
  rest: Float64Array,
  moved: readonly { vectors: Float64Array; weight: number }[],
): number {
  let sum = 0
  let total = 0
  for (let t = 0; t < weights.length; t++) {
    let x = rest[3 * t]
    let y = rest[3 * t + 1]
    let z = rest[3 * t + 2]
    for (let i = 0; i < moved.length; i++) {
      const { vectors, weight } = moved[i]
      x += weight * vectors[3 * t]
      y += weight * vectors[3 * t + 1]
      z += weight * vectors[3 * t + 2]
    }
    sum += weights[t] * (1 - Math.sqrt(x * x + y * y + z * z))
    total += weights[t]
  }
  return sum / total
}
