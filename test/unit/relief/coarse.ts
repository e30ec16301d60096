import { SphereGeometry } from 'three'
import type { CoarseMesh } from '../../../packages/furrow/src/relief/coarse-mesh.ts'

/** Makes a sphere that has a UV seam, and several vertices at each pole. */
export function sphere(radius: number, segments = 12): CoarseMesh & { normals: ArrayLike<number> } {
  const { attributes, index } = new SphereGeometry(radius, segments, segments)
  // Rounds positions, so that both sides of the seam are equal: cos(2 * PI) and sin(2 * PI) are inexact.
  const positions = Float32Array.from(attributes.position.array, (value) => Math.round(value * 1e6) / 1e6 + 0)
  return {
    positions,
    uvs: attributes.uv.array,
    triangles: index!.array,
    normals: attributes.normal.array,
  }
}

/** Runs a generator to its end. */
export function finish<T>(steps: Generator<void, T>): T {
  for (;;) {
    const { done, value } = steps.next()
    if (done) return value
  }
}
