import type { GrayImage } from '../core/types.ts'
import { coverTexels } from './cover-texels.ts'
import { dilate } from './dilate.ts'
import type { MetricMesh } from './metric.ts'

/** Texels by which an area reaches beyond the islands of the texture, so that filtering finds no seam. */
const RINGS = 2

/**
 * The area that a blendshape or a muscle moves: weights grow with the square root of the way, from 0 where the skin holds still to 1
 * where it moves most, so that the edge is soft and yet all that moves is in it.
 *
 * @param mesh its positions are not needed.
 * @param offsets x, y and z by which each vertex moves.
 * @param size side in texels.
 */
export function targetArea(
  { uvs, indices }: Pick<MetricMesh, 'uvs' | 'indices'>,
  offsets: ArrayLike<number>,
  size: number,
): GrayImage {
  const ways = Float64Array.from({ length: offsets.length / 3 }, (_, i) =>
    Math.hypot(offsets[3 * i]!, offsets[3 * i + 1]!, offsets[3 * i + 2]!),
  )
  const most = ways.reduce((a, b) => Math.max(a, b), 0)
  const known = new Uint8Array(size * size)
  const weights = new Float32Array(size * size)
  const count = indices?.length ?? ways.length
  for (let t = 0; most > 0 && t + 2 < count; t += 3) {
    const corners = [0, 1, 2].map((k) => (indices ? indices[t + k]! : t + k)) as [number, number, number]
    const [p, q, r] = corners.map((i) => Math.sqrt(ways[i]! / most)) as [number, number, number]
    coverTexels(uvs, corners, size, size, (texel, a, b, c) => {
      weights[texel] = Math.max(weights[texel]!, a * p + b * q + c * r)
      known[texel] = 1
    })
  }
  dilate(known, size, [{ data: weights, channels: 1 }], RINGS)
  const data = Uint8Array.from(weights, (weight) => Math.round(255 * Math.min(weight, 1)))
  return { width: size, height: size, data }
}
