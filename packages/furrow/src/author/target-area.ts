import type { GrayImage } from '../core/types.ts'
import { smoothstep } from '../math/scalar.ts'
import { principalStretches, restInverse } from '../math/stretch.ts'
import { coverTexels } from './cover-texels.ts'
import { dilate } from './dilate.ts'
import type { MetricMesh } from './metric.ts'

/** Texels by which an area reaches beyond the islands of the texture, so that filtering finds no seam. */
const RINGS = 2
/** Weight of skin that moves, but is not pushed together: it is stretched, and its wrinkles go. */
const STRETCHED = 0.12
/** Weight of whatever moves at all: rounded to a byte it is not lost. */
const LEAST = 1.5 / 255
/** Compression at which skin wrinkles fully, as a share of the strongest: that of few triangles, where it folds. */
const ENOUGH = 0.35

/**
 * The area that a blendshape or a muscle moves. Weights grow with the square root of the way, from 0 where the skin holds still to 1
 * where it moves most, so that the edge is soft and yet all that moves is in it; they are small where skin is stretched and not
 * pushed together, as beyond a muscle's end.
 *
 * @param offsets x, y and z by which each vertex moves.
 * @param size side in texels.
 */
export function targetArea(mesh: MetricMesh, offsets: ArrayLike<number>, size: number): GrayImage {
  const { uvs, indices } = mesh
  const triangles = indices ?? Array.from({ length: offsets.length / 3 }, (_, i) => i)
  const moved = vertexWeights(mesh, triangles, offsets)
  const known = new Uint8Array(size * size)
  const weights = new Float32Array(size * size)
  for (let t = 0; t + 2 < triangles.length; t += 3) {
    const corners = [triangles[t], triangles[t + 1], triangles[t + 2]] as const
    const [p, q, r] = corners.map((i) => moved[i]) as [number, number, number]
    coverTexels(uvs, corners, size, size, (texel, a, b, c) => {
      weights[texel] = Math.max(weights[texel], a * p + b * q + c * r)
      known[texel] = 1
    })
  }
  // Triangles may be too small to cover the centre of a texel.
  for (const [i, weight] of moved.entries()) {
    const column = Math.min(Math.max(Math.floor(uvs[2 * i] * size), 0), size - 1)
    const row = Math.min(Math.max(Math.floor(uvs[2 * i + 1] * size), 0), size - 1)
    const texel = row * size + column
    weights[texel] = Math.max(weights[texel], weight)
    known[texel] = 1
  }
  dilate(known, size, [{ data: weights, channels: 1 }], RINGS)
  const data = Uint8Array.from(weights, (weight) => Math.round(255 * Math.min(weight, 1)))
  return { width: size, height: size, data }
}

function vertexWeights(
  mesh: MetricMesh,
  triangles: ArrayLike<number>,
  offsets: ArrayLike<number>,
): Float64Array {
  const weights = new Float64Array(offsets.length / 3)
  for (let i = 0; i < weights.length; i++) {
    weights[i] = Math.hypot(offsets[3 * i], offsets[3 * i + 1], offsets[3 * i + 2])
  }
  const most = weights.reduce((a, b) => Math.max(a, b), 0)
  if (!(most > 0)) return weights
  const pushed = compressions(mesh, triangles, offsets)
  const strongest = pushed.reduce((a, b) => Math.max(a, b), 1e-9)
  return weights.map((way, i) => {
    if (way === 0) return 0
    const together = smoothstep(pushed[i] / (ENOUGH * strongest))
    return Math.max(LEAST, Math.sqrt(way / most) * (STRETCHED + (1 - STRETCHED) * together))
  })
}

/** Share by which skin is shortened round each vertex: the mean of its triangles, 0 where it is not. */
function compressions(
  { positions }: MetricMesh,
  triangles: ArrayLike<number>,
  offsets: ArrayLike<number>,
): Float64Array {
  const now = Float64Array.from(positions, (value, i) => value + offsets[i])
  const sums = new Float64Array(positions.length / 3)
  const counts = new Uint32Array(sums.length)
  const stretches = new Float64Array(2)
  for (let t = 0; t + 2 < triangles.length; t += 3) {
    const [a, b, c] = [triangles[t], triangles[t + 1], triangles[t + 2]]
    const inverse = restInverse(a, b, c, positions)
    if (!inverse) continue
    principalStretches(stretches, inverse, 0, a, b, c, now)
    for (const i of [a, b, c]) {
      sums[i] += Math.max(0, 1 - stretches[0])
      counts[i]++
    }
  }
  return sums.map((sum, i) => sum / Math.max(1, counts[i]))
}
