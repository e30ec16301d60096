import { FurrowError } from '../../core/error.ts'
import type { Skin } from './surface.ts'

/** How many textures the bounding boxes of all triangles may fill together: those of a face fill about two. */
const MOST_COVERAGE = 128

/**
 * Checks that the triangles of a skin, which are drawn one by one, do not lie on top of each other by the hundred: few bytes can stand for
 * hundreds of thousands of triangles that each fill the texture.
 *
 * @param skin in the first tile of its texture; what is outside does not count.
 * @param who draws it.
 * @throws FurrowError when their bounding boxes in the texture are too large together.
 */
export function checkCoverage({ uvs, indices }: Pick<Skin, 'uvs' | 'indices'>, who: string): void {
  let sum = 0
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const [a, b, c] = [2 * indices[t], 2 * indices[t + 1], 2 * indices[t + 2]]
    sum += extent(uvs[a], uvs[b], uvs[c]) * extent(uvs[a + 1], uvs[b + 1], uvs[c + 1])
  }
  if (sum <= MOST_COVERAGE) return
  throw new FurrowError({
    code: 'out-of-range',
    who,
    problem: 'too many triangles of the skin lie on top of each other in its texture',
    value: `${Math.round(sum)} times its size`,
    limit: `${MOST_COVERAGE} times`,
    remedy: 'unwrap the mesh such that each triangle has texels of its own',
  })
}

/** From the least to the largest of three coordinates, within 0..1. */
function extent(a: number, b: number, c: number): number {
  const [low, high] = [Math.max(0, Math.min(a, b, c)), Math.min(1, Math.max(a, b, c))]
  return Math.max(0, high - low)
}
