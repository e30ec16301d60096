import { coverTexels } from '../cover-texels.ts'
import { cornersOf, type Skin, type SkinSurface, skinVertices } from './surface.ts'

/** Side of the map on which overlaps are searched, in texels. */
const SIZE = 256
/** Fraction of the covered texels that may be covered twice by chance. */
const CHANCE = 0.05

/** Texels that several parts of a skin use. */
export interface UvOverlap {
  /** Whether the left and right half of the face use the same texels. */
  isMirrored: boolean
  /** Fraction of the covered texels that are used more than once, 0..1. */
  fraction: number
}

/** Searches for texels that several parts of the skin use. */
export function findOverlap(skin: Pick<Skin, 'uvs' | 'indices'>, surface: SkinSurface): UvOverlap {
  const { points, skinTriangles } = surface
  const sides = new Uint8Array(SIZE * SIZE)
  const counts = new Uint8Array(SIZE * SIZE)
  for (let t = 0; t < skinTriangles.length; t++) {
    const middle = cornersOf(surface, t).reduce((sum, point) => sum + points[3 * point] / 3, 0)
    coverTexels(skin.uvs, skinVertices(skin, surface, t), SIZE, SIZE, (texel, a, b, c) => {
      // Adjacent triangles both cover the texels of their edge.
      if (Math.min(a, b, c) < 1e-3) return
      counts[texel] = Math.min(255, counts[texel] + 1)
      sides[texel] |= middle > 0 ? 1 : 2
    })
  }
  let [covered, twice, bothSides] = [0, 0, 0]
  for (let i = 0; i < counts.length; i++) {
    if (counts[i] > 0) covered++
    if (counts[i] > 1) twice++
    if (counts[i] > 1 && sides[i] === 3) bothSides++
  }
  return {
    fraction: covered > 0 ? twice / covered : 0,
    isMirrored: bothSides > CHANCE * covered && bothSides > twice / 2,
  }
}

/** Whether an overlap is more than chance. */
export function isOverlapped({ fraction }: UvOverlap): boolean {
  return fraction > CHANCE
}

/** Tells whether a triangle reaches the left side of the face. */
export function isOnLeft(surface: SkinSurface): (triangle: number) => boolean {
  const { points } = surface
  return (triangle) => cornersOf(surface, triangle).some((point) => points[3 * point] > 0)
}
