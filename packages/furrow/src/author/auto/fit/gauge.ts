import { cross } from '../../../math/vector.ts'
import { crossOf, type SkinSurface } from '../../skin/surface.ts'
import { LineGrid } from '../../strokes/line-grid.ts'
import type { SkinRegion } from '../anatomy/region.ts'
import type { Crease } from '../lines/crease.ts'
import { unroll } from '../surface/head-chart.ts'
import type { Pose } from '../surface/pose.ts'

/** Measures how far poses compress the skin of a region across its lines. */
export interface Gauge {
  /** Three points per triangle of the region. */
  corners: Uint32Array
  /** Per triangle the unit vector across the nearest line, as multiples of the triangle's two edges from its first corner. */
  across: Float64Array
  /** Per triangle. */
  weights: Float64Array
}

/**
 * Makes a gauge of the triangles within reach of a region's lines.
 *
 * @returns undefined where there are none.
 */
export function makeGauge(
  { points, normals, corners }: SkinSurface,
  { reach, influence }: SkinRegion,
  creases: readonly Crease[],
): Gauge | undefined {
  const grid = new LineGrid(
    creases,
    creases.map(() => reach),
  )
  const [chosen, across, weights]: number[][] = [[], [], []]
  const [normal, perpendicular] = [new Float64Array(3), new Float64Array(3)]
  for (let t = 0; t < corners.length; t += 3) {
    const [a, b, c] = [corners[t], corners[t + 1], corners[t + 2]]
    const [x, y, z] = [0, 1, 2].map((k) => (points[3 * a + k] + points[3 * b + k] + points[3 * c + k]) / 3)
    let [closest, line, segment] = [Infinity, -1, 0]
    grid.visit(x, y, z, normals[3 * a], normals[3 * a + 1], normals[3 * a + 2], (crease, distance, at) => {
      if (distance < closest) [closest, line, segment] = [distance, crease, at]
    })
    if (line < 0) continue
    const regionWeight = influence?.(unroll(x, y, z)) ?? 1
    const weight = regionWeight * (1 - closest / reach) * crossOf(points, a, b, c, normal)
    if (!(weight > 0)) continue
    const p = creases[line].points
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

/** The unit vector along v, in a triangle's plane, as multiples of the triangle's edges from a to b and from a to c. */
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

/** The mean fraction by which a pose shortens the skin across the lines; below 0 where it stretches it. */
export function measureCompression(
  { points }: SkinSurface,
  { corners, across, weights }: Gauge,
  offsets: readonly Float64Array[],
  pose: Pose,
): number {
  let [sum, total] = [0, 0]
  const parts = [...pose].map(([target, weight]) => ({ offset: offsets[target], weight }))
  for (let t = 0; t < weights.length; t++) {
    let square = 0
    for (let k = 0; k < 3; k++) {
      const deformed = (corner: number) => {
        const i = 3 * corners[3 * t + corner] + k
        let value = points[i]
        for (const { offset, weight } of parts) value += weight * offset[i]
        return value
      }
      const origin = deformed(0)
      square += (across[2 * t] * (deformed(1) - origin) + across[2 * t + 1] * (deformed(2) - origin)) ** 2
    }
    sum += weights[t] * (1 - Math.sqrt(square))
    total += weights[t]
  }
  return sum / total
}
