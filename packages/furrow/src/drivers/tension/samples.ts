import { repeat } from '../../core/repeat.ts'
import type { GrayImage } from '../../core/types.ts'

/** A triangle mesh with texture coordinates, from which triangles are sampled. */
export interface SampledMesh {
  /** xyz of each vertex at rest. */
  positions: ArrayLike<number>
  /** u and v of each vertex, v downwards, in the UV layout of the areas. Coordinates outside 0..1 repeat. */
  uvs: ArrayLike<number>
  /** Three indices of vertices per triangle. */
  triangles: ArrayLike<number>
}

/**
 * Selects sample triangles of an area of influence. A triangle can be selected several times: the number is proportional to the size of the
 * triangle times the weight there. The mean of a quantity over the samples therefore estimates its weighted mean over the skin.
 *
 * @param weights weights of the area, row 0 at v = 0.
 * @param count number of samples.
 * @returns three indices of vertices per sample. Empty if the area covers no triangle.
 */
export function sampleTriangles(mesh: SampledMesh, weights: GrayImage, count: number): Uint32Array {
  return sampleCovered(mesh, coverage(mesh, weights), count)
}

/**
 * Selects sample triangles as `sampleTriangles` does.
 *
 * @param covered result of `coverage`.
 * @returns three indices of vertices per sample. Empty if `covered` is 0 for all triangles.
 */
export function sampleCovered({ triangles }: SampledMesh, covered: Float64Array, count: number): Uint32Array {
  let sum = 0
  const cumulative = covered.map((coverage) => {
    sum += coverage
    return sum
  })
  if (!(sum > 0)) return new Uint32Array()
  const corners: number[] = []
  let k = 0
  for (let i = 0; i < count; i++) {
    while (cumulative[k] < ((i + 0.5) / count) * sum) k++
    corners.push(triangles[3 * k], triangles[3 * k + 1], triangles[3 * k + 2])
  }
  return Uint32Array.from(corners)
}

/** Computes the coverage of each triangle: the weight at the centroid, 0..1, times the surface area of the triangle at rest. */
export function coverage(mesh: SampledMesh, weights: GrayImage): Float64Array {
  return Float64Array.from(
    { length: mesh.triangles.length / 3 },
    (_, k) => weightOf(mesh, weights, k) * surface(mesh, k),
  )
}

/** Returns the weight of an area at a triangle's centroid, 0..1. */
function weightOf({ uvs, triangles }: SampledMesh, { width, height, data }: GrayImage, k: number): number {
  let [u, v] = [0, 0]
  for (let corner = 0; corner < 3; corner++) {
    u += uvs[2 * triangles[3 * k + corner]] / 3
    v += uvs[2 * triangles[3 * k + corner] + 1] / 3
  }
  const texel = (coordinate: number, size: number) =>
    Math.min(Math.max(Math.floor(coordinate * size), 0), size - 1)
  return data[texel(repeat(v), height) * width + texel(repeat(u), width)] / 255 || 0
}

/** Returns the surface area of a triangle at rest, or 0 if a position is NaN or infinite. */
function surface({ positions, triangles }: SampledMesh, k: number): number {
  const edge = (corner: number, axis: number) =>
    positions[3 * triangles[3 * k + corner] + axis] - positions[3 * triangles[3 * k] + axis]
  const cross = (a: number, b: number) => edge(1, a) * edge(2, b) - edge(1, b) * edge(2, a)
  const area = Math.hypot(cross(1, 2), cross(2, 0), cross(0, 1)) / 2
  return Number.isFinite(area) ? area : 0
}
