/**
 * Reference implementation of relief in float64. Relief moves the surface of a mesh by the height maps of wrinkle layers. Tests compare
 * the shaders of all renderers with this module.
 */
import type { DenseMesh } from './dense-mesh.ts'

/**
 * Shape factor of Phong tessellation, 0..1 (T. Boubekeur, M. Alexa, "Phong Tessellation", 2008). The factor 1/2 reproduces quadratic
 * surfaces exactly. The authors recommend 3/4, chosen by eye.
 */
export const PHONG = 0.5

/** Clearance in metres (see `outwardClearance`) at which Phong tessellation has its full effect. Less clearance reduces the curvature. */
export const CLEARANCE_TO_CURVE = 0.0005

/** Coarse mesh in its current pose. */
export interface DeformedMesh {
  /** Packed xyz per vertex. */
  positions: ArrayLike<number>
  /** Unit normals, packed xyz per vertex. Vertices at one position may have different normals. */
  normals: ArrayLike<number>
}

/**
 * Computes the displacement of a point by all layers.
 *
 * @param layers `influence`: 0..1. `height`: 0..1, 0.5 = undisplaced. `amplitude`: metres between heights 0 and 1.
 * @returns displacement in metres, positive outwards.
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
 * Computes the vertex positions of a dense mesh. Phong tessellation curves the triangles of the deformed coarse mesh. Each vertex is
 * interpolated on its curved triangle, and then moved along the smooth normal.
 *
 * @param heightAt returns the displacement at texture coordinates, in metres, positive outwards.
 * @param clearance maximum displacement at each coarse vertex, in metres; see `outwardClearance`. Displacements in either direction are
 *   clamped to it. It also limits the effect of Phong tessellation, so that parts that touch, such as lips, stay in contact.
 * @param amount 0 = the coarse mesh, 1 = full relief.
 * @returns packed xyz per dense vertex.
 */
export function displace(
  dense: DenseMesh,
  { positions, normals }: DeformedMesh,
  heightAt: (u: number, v: number) => number,
  clearance: ArrayLike<number>,
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
    const most = corners.reduce((total, { vertex, weight }) => total + weight * clearance[vertex / 3], 0)
    const curvature = PHONG * amount * Math.min(most / CLEARANCE_TO_CURVE, 1)
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

/** Averages the normals of all vertices at each position. If the normals cancel out, uses the normal of the first vertex. */
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

/** Minimum length of a sum of unit normals. Shorter sums have no meaningful direction. */
export const CANCELLED = 1e-3

function unit(vector: readonly number[]): number[] {
  const length = Math.hypot(...vector) || 1
  return vector.map((value) => value / length)
}
