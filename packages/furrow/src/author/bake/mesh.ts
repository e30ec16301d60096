import { length } from '../../math/vector.ts'

/** Unindexed mesh that maps are baked for. Every three corners form a triangle. */
export interface BakeMesh {
  /** Packed xyz per corner, in metres. */
  positions: Float32Array
  /** Unit shading normal of each corner. */
  normals: Float32Array
  /** Packed uv per corner, v = 0 at the top. UVs outside 0..1 wrap. */
  uvs: Float32Array
  /** Tangent of each corner, four numbers with w = 1 or -1 as in glTF. Without tangents, maps have the `derivative` frame (`TangentFrame`). */
  tangents?: Float32Array
}

/**
 * Returns a unit vector per corner: the mean normal of all corners at the same position. Rays along these vectors leave no gaps at hard edges
 * or UV seams.
 */
export function sharedNormals({ positions, normals }: Pick<BakeMesh, 'positions' | 'normals'>): Float32Array {
  const sums = new Map<string, Float64Array>()
  const corners = positions.length / 3
  const sumOf: Float64Array[] = []
  for (let i = 0; i < corners; i++) {
    const key = `${positions[3 * i]},${positions[3 * i + 1]},${positions[3 * i + 2]}`
    let sum = sums.get(key)
    if (!sum) {
      sum = new Float64Array(3)
      sums.set(key, sum)
    }
    for (let k = 0; k < 3; k++) sum[k] += normals[3 * i + k]
    sumOf.push(sum)
  }
  const shared = new Float32Array(positions.length)
  for (let i = 0; i < corners; i++) {
    const scale = length(sumOf[i])
    // Opposite normals cancel out. In this case, each corner keeps its normal.
    for (let k = 0; k < 3; k++) shared[3 * i + k] = scale > 1e-3 ? sumOf[i][k] / scale : normals[3 * i + k]
  }
  return shared
}
