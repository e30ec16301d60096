/** Computes relief in float64. Tests compare the shaders of both renderers with it. */
import type { DenseMesh } from './dense-mesh.ts'

/**
 * Shape factor of Phong tessellation: 0 = flat triangle, 1 = projections onto the tangent planes of the corners (T. Boubekeur, M. Alexa,
 * "Phong Tessellation", 2008). The authors choose 3/4 by eye; 1/2 reproduces quadratic surfaces exactly.
 */
export const PHONG = 0.5

/** Room in metres at which Phong tessellation reaches its full strength. */
export const ROOM_TO_CURVE = 0.0005

/** Current deformation of the coarse mesh. */
export interface DeformedMesh {
  /** x, y and z of each vertex. */
  positions: ArrayLike<number>
  /** Unit normal of each vertex; vertices at one position may have different normals. */
  normals: ArrayLike<number>
}

/**
 * Sums the outward displacement of all layers.
 *
 * @param layers influence, 0..1; height, 0..1, 0.5 = undisplaced; and amplitude, metres from height 0 to 1.
 * @returns metres.
 */
export function displacement(
  layers: readonly { influence: number; height: number; amplitude: number }[],
): number {
  return layers.reduce(
    (sum, { influence, height, amplitude }) => sum + influence * (height - 0.5) * amplitude,
    0,
  )
}

/**
 * Displaces a dense mesh. Places each vertex on its deformed coarse triangle, curves the triangle by Phong tessellation, and moves the vertex
 * along the smooth normal.
 *
 * @param heightAt returns the outward displacement at texture coordinates, metres.
 * @param room maximum displacement of each coarse vertex in either direction, metres, see `outwardRoom`. Without room the surface stays flat,
 *   because another mesh may be next to it.
 * @param amount 0 = the coarse mesh, 1 = full relief.
 * @returns x, y and z of each dense vertex.
 */
export function displace(
  dense: DenseMesh,
  { positions, normals }: DeformedMesh,
  heightAt: (u: number, v: number) => number,
  room: ArrayLike<number>,
  amount = 1,
): Float64Array {
  const out = new Float64Array(3 * dense.count)
  const smooth = smoothNormals(normals, dense.firstOf)
  for (let i = 0; i < dense.count; i++) {
    const corners = [0, 1, 2].map((k) => ({
      vertex: 3 * dense.parents[3 * i + k],
      weight: dense.weights[3 * i + k],
    }))
    const sum = (values: ArrayLike<number>, axis: number) =>
      corners.reduce((total, { vertex, weight }) => total + weight * values[vertex + axis], 0)
    const flat = [0, 1, 2].map((axis) => sum(positions, axis))
    const normal = unit([0, 1, 2].map((axis) => sum(smooth, axis)))
    const curved = flat.slice()
    const most = corners.reduce((total, { vertex, weight }) => total + weight * room[vertex / 3], 0)
    const curvature = PHONG * amount * Math.min(most / ROOM_TO_CURVE, 1)
    for (const { vertex, weight } of corners) {
      const beyond = [0, 1, 2].reduce(
        (total, axis) => total + (flat[axis] - positions[vertex + axis]) * smooth[vertex + axis],
        0,
      )
      for (const axis of [0, 1, 2]) curved[axis] -= curvature * weight * beyond * smooth[vertex + axis]
    }
    const [u0, v0, u1, v1] = dense.uvs.subarray(4 * i, 4 * i + 4)
    const height = (heightAt(u0, v0) + heightAt(u1, v1)) / 2
    const outwards = Math.min(Math.max(height, -most), most) * amount
    for (const axis of [0, 1, 2]) out[3 * i + axis] = curved[axis] + normal[axis] * outwards
  }
  return out
}

/** Averages the normals of all vertices at one position, for each first vertex. Keeps the vertex's own normal if they cancel out. */
export function smoothNormals(normals: ArrayLike<number>, firstOf: ArrayLike<number>): Float64Array {
  const sums = new Float64Array(normals.length)
  for (let i = 0; i < firstOf.length; i++) {
    for (let axis = 0; axis < 3; axis++) sums[3 * firstOf[i] + axis] += normals[3 * i + axis]
  }
  for (let i = 0; i < 3 * firstOf.length; i += 3) {
    if (3 * firstOf[i / 3] !== i) continue
    const hasDirection = Math.hypot(sums[i], sums[i + 1], sums[i + 2]) > CANCELLED
    if (!hasDirection) for (let k = i; k < i + 3; k++) sums[k] = normals[k]
    const length = Math.hypot(sums[i], sums[i + 1], sums[i + 2]) || 1
    for (let k = i; k < i + 3; k++) sums[k] /= length
  }
  return sums
}

/** Length; shorter sums of unit normals have no usable direction. */
export const CANCELLED = 1e-3

function unit(vector: readonly number[]): number[] {
  const length = Math.hypot(...vector) || 1
  return vector.map((value) => value / length)
}
