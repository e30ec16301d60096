/** A mesh that maps are baked for: three corners per triangle that share nothing with other triangles. */
export interface BakeMesh {
  /** x, y, z per corner in metres. */
  positions: Float32Array
  /** Shading normal per corner, of unit length. */
  normals: Float32Array
  /** u, v per corner, v = 0 at the top. Outside 0..1 the texture repeats. */
  uvs: Float32Array
  /** Tangent per corner, w = 1 or -1 as in glTF; without, the map is for the derivative frame (see TangentFrame). */
  tangents?: Float32Array
}

/**
 * One direction per corner, the same for all corners at one place: the mean of their normals. Rays sent along it leave
 * no gap where the shading has a hard edge or the texture a seam.
 */
export function sharedNormals({ positions, normals }: Pick<BakeMesh, 'positions' | 'normals'>): Float32Array {
  const sums = new Map<string, Float64Array>()
  const corners = positions.length / 3
  const owner: Float64Array[] = []
  for (let i = 0; i < corners; i++) {
    const key = `${positions[3 * i]},${positions[3 * i + 1]},${positions[3 * i + 2]}`
    let sum = sums.get(key)
    if (!sum) {
      sum = new Float64Array(3)
      sums.set(key, sum)
    }
    for (let k = 0; k < 3; k++) sum[k] += normals[3 * i + k]
    owner.push(sum)
  }
  const shared = new Float32Array(positions.length)
  for (let i = 0; i < corners; i++) {
    const [x, y, z] = owner[i] as unknown as [number, number, number]
    const length = Math.hypot(x, y, z)
    // Where normals cancel out, on a knife's edge, each corner keeps its own.
    for (let k = 0; k < 3; k++) shared[3 * i + k] = length > 1e-3 ? owner[i][k] / length : normals[3 * i + k]
  }
  return shared
}
