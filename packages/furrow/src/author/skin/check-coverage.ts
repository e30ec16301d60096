import { FurrowError } from '../../core/error.ts'
import type { Skin } from './surface.ts'

/** Maximum total area of the triangles' UV bounding boxes, in units of the texture's area. Typical faces reach about 2. */
const MAX_COVERAGE = 128

/**
 * Rejects meshes with hundreds of overlapping triangles in UV space. Drawing time grows with the total area of the triangles, and a small
 * file can hold hundreds of thousands of triangles that each fill the texture.
 *
 * @param skin mesh to check. Parts of its triangles outside the UV range 0..1 are ignored.
 * @param who function name for the error.
 * @throws FurrowError if the total area of the bounding boxes is too large.
 */
export function checkCoverage({ uvs, indices }: Pick<Skin, 'uvs' | 'indices'>, who: string): void {
  let sum = 0
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const [a, b, c] = [2 * indices[t], 2 * indices[t + 1], 2 * indices[t + 2]]
    sum += extent(uvs[a], uvs[b], uvs[c]) * extent(uvs[a + 1], uvs[b + 1], uvs[c + 1])
  }
  if (sum <= MAX_COVERAGE) return
  throw new FurrowError({
    code: 'out-of-range',
    who,
    problem: 'too many overlapping triangles in UV space',
    value: `${Math.round(sum)} times the texture`,
    limit: `${MAX_COVERAGE} times`,
    remedy: 'unwrap the mesh so that each triangle has its own texels',
  })
}

/** Returns the range of three coordinates, clipped to 0..1. */
function extent(a: number, b: number, c: number): number {
  const [low, high] = [Math.max(0, Math.min(a, b, c)), Math.min(1, Math.max(a, b, c))]
  return Math.max(0, high - low)
}
