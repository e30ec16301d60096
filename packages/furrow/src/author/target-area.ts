import type { GrayImage } from '../core/types.ts'
import { clamp, smoothstep } from '../math/scalar.ts'
import { principalStretches, restInverse } from '../math/stretch.ts'
import { length3 } from '../math/vector.ts'
import { dilate } from './border.ts'
import { coverTexels } from './cover-texels.ts'
import type { MetricMesh } from './metric.ts'

/** Margin around the UV islands in texels, so that filtering shows no seams. */
const MARGIN = 2
/** Factor on the weight of skin that moves without being compressed. It is small, because stretched skin has no wrinkles. */
const STRETCHED_WEIGHT = 0.12
/** Minimum weight of moving skin. It must not round to byte 0. */
const MIN_WEIGHT = 1.5 / 255
/** Fraction of the maximum compression that counts as full compression. Only a few triangles, where the mesh folds, reach the maximum. */
const FULL_COMPRESSION = 0.35

/**
 * Computes the area of influence of a blendshape or a muscle: a map of weights that tells where its wrinkles appear. Weights grow with the
 * square root of the displacement, from 0 for still skin to 1 for compressed skin at the largest displacement. Stretched skin, for example
 * beyond a muscle's end, gets small weights. The area has a soft edge and includes all skin that moves.
 *
 * @param offsets packed xyz displacement per vertex.
 * @param size width and height of the area in texels.
 */
export function targetArea(mesh: MetricMesh, offsets: ArrayLike<number>, size: number): GrayImage {
  const { uvs } = mesh
  const triangles = mesh.indices ?? Array.from({ length: offsets.length / 3 }, (_, i) => i)
  const vertexWeights = weightVertices(mesh, triangles, offsets)
  const known = new Uint8Array(size * size)
  const weights = new Float32Array(size * size)
  for (let t = 0; t + 2 < triangles.length; t += 3) {
    const vertices = [triangles[t], triangles[t + 1], triangles[t + 2]] as const
    const [p, q, r] = vertices.map((i) => vertexWeights[i])
    coverTexels(uvs, vertices, size, size, (texel, a, b, c) => {
      weights[texel] = Math.max(weights[texel], a * p + b * q + c * r)
      known[texel] = 1
    })
  }
  // Triangles may be too small to cover the centre of a texel, so each vertex also writes to the texel that contains it.
  for (const [i, weight] of vertexWeights.entries()) {
    const column = clamp(Math.floor(uvs[2 * i] * size), 0, size - 1)
    const row = clamp(Math.floor(uvs[2 * i + 1] * size), 0, size - 1)
    const texel = row * size + column
    weights[texel] = Math.max(weights[texel], weight)
    known[texel] = 1
  }
  dilate(known, size, [{ data: weights, channels: 1 }], MARGIN)
  const data = Uint8Array.from(weights, (weight) => Math.round(255 * Math.min(weight, 1)))
  return { width: size, height: size, data }
}

function weightVertices(
  mesh: MetricMesh,
  triangles: ArrayLike<number>,
  offsets: ArrayLike<number>,
): Float64Array {
  const displacements = new Float64Array(offsets.length / 3)
  for (let i = 0; i < displacements.length; i++) {
    displacements[i] = length3(offsets[3 * i], offsets[3 * i + 1], offsets[3 * i + 2])
  }
  const largest = displacements.reduce((a, b) => Math.max(a, b), 0)
  if (!(largest > 0)) return displacements
  const compressions = vertexCompressions(mesh, triangles, offsets)
  const strongest = compressions.reduce((a, b) => Math.max(a, b), 1e-9)
  return displacements.map((displacement, i) => {
    if (displacement === 0) return 0
    const compressed = smoothstep(compressions[i] / (FULL_COMPRESSION * strongest))
    const weight =
      Math.sqrt(displacement / largest) * (STRETCHED_WEIGHT + (1 - STRETCHED_WEIGHT) * compressed)
    return Math.max(MIN_WEIGHT, weight)
  })
}

/** Returns the fraction by which the skin around each vertex is shortened: the mean over the vertex's triangles, 0..1. */
function vertexCompressions(
  { positions }: MetricMesh,
  triangles: ArrayLike<number>,
  offsets: ArrayLike<number>,
): Float64Array {
  const moved = Float64Array.from(positions, (value, i) => value + offsets[i])
  const sums = new Float64Array(positions.length / 3)
  const counts = new Uint32Array(sums.length)
  const stretches = new Float64Array(2)
  for (let t = 0; t + 2 < triangles.length; t += 3) {
    const [a, b, c] = [triangles[t], triangles[t + 1], triangles[t + 2]]
    const inverse = restInverse(a, b, c, positions)
    if (!inverse) continue
    principalStretches(stretches, inverse, 0, a, b, c, moved)
    for (const i of [a, b, c]) {
      sums[i] += Math.max(0, 1 - stretches[0])
      counts[i]++
    }
  }
  return sums.map((sum, i) => sum / Math.max(1, counts[i]))
}
