import { weldVertices } from '../../math/weld.ts'
import { coverTexels } from '../cover-texels.ts'
import { islandsOf } from './islands.ts'
import { cornersOf, type Skin, type SkinSurface, skinVertices } from './surface.ts'

/** Width and height in texels of the map used to detect overlaps. */
const SIZE = 256
/** Maximum fraction of the covered texels that may be shared. A larger fraction counts as an overlap. */
const TOLERANCE = 0.05

/** Result of `findOverlap`. */
export interface UvOverlap {
  /** Fraction of the covered texels used more than once, 0..1. */
  fraction: number
  /** For each triangle, whether the left and right halves of the skin share the triangle's UV island. Undefined if they share no island. */
  isMirrored: readonly boolean[] | undefined
}

type Textured = Pick<Skin, 'uvs' | 'indices'>

/** Texel counts of a part of the skin. */
interface Use {
  /** Texels that at least one triangle covers. */
  covered: number
  /** Texels that several triangles cover. */
  twice: number
  /** Texels that triangles of both the left and the right half cover. */
  bothSides: number
}

/** Detects texels that several triangles of the skin cover. */
export function findOverlap(skin: Textured, surface: SkinSurface): UvOverlap {
  const { points, skinTriangles } = surface
  const sides = new Uint8Array(SIZE * SIZE)
  const counts = new Uint8Array(SIZE * SIZE)
  for (let t = 0; t < skinTriangles.length; t++) {
    const middle = cornersOf(surface, t).reduce((sum, point) => sum + points[3 * point] / 3, 0)
    visitTexels(skin, surface, t, (texel) => {
      counts[texel] = Math.min(255, counts[texel] + 1)
      sides[texel] |= middle > 0 ? 1 : 2
    })
  }
  const count = (use: Use, texel: number) => {
    use.covered++
    if (counts[texel] > 1) use.twice++
    if (counts[texel] > 1 && sides[texel] === 3) use.bothSides++
  }
  const all: Use = { covered: 0, twice: 0, bothSides: 0 }
  for (let i = 0; i < counts.length; i++) if (counts[i] > 0) count(all, i)
  return {
    fraction: all.covered > 0 ? all.twice / all.covered : 0,
    isMirrored: usesBothSides(all) ? mirroredTriangles(skin, surface, count) : undefined,
  }
}

/** Computes `UvOverlap.isMirrored`. Each UV island is tested separately, because often the limbs share texels but the face does not. */
function mirroredTriangles(
  skin: Textured,
  surface: SkinSurface,
  count: (use: Use, texel: number) => void,
): boolean[] {
  const { pointOf, skinTriangles } = surface
  const textured = Float64Array.from({ length: 3 * pointOf.length }, (_, i) => {
    const vertex = Math.floor(i / 3)
    return i % 3 === 2 ? pointOf[vertex] : skin.uvs[2 * vertex + (i % 3)]
  })
  const welded = weldVertices(textured)
  const corners = Uint32Array.from({ length: skin.indices.length }, (_, i) => welded.pointOf[skin.indices[i]])
  const islands = islandsOf(corners, welded.count)
  const uses = new Map<number, Use>()
  const useOf = Array.from(skinTriangles, (triangle, t) => {
    const island = islands[corners[3 * triangle]]
    const use = uses.get(island) ?? { covered: 0, twice: 0, bothSides: 0 }
    uses.set(island, use)
    visitTexels(skin, surface, t, (texel) => count(use, texel))
    return use
  })
  return useOf.map(usesBothSides)
}

/** Visits the texels that a triangle covers, except texels on its edges, because adjacent triangles also cover these. */
function visitTexels(
  skin: Textured,
  surface: SkinSurface,
  triangle: number,
  visit: (texel: number) => void,
): void {
  coverTexels(skin.uvs, skinVertices(skin, surface, triangle), SIZE, SIZE, (texel, a, b, c) => {
    if (Math.min(a, b, c) >= 1e-3) visit(texel)
  })
}

function usesBothSides({ covered, twice, bothSides }: Use): boolean {
  return bothSides > TOLERANCE * covered && bothSides > twice / 2
}

export function isOverlapped({ fraction }: UvOverlap): boolean {
  return fraction > TOLERANCE
}

/**
 * Selects the triangles to draw into the texture. In a UV island shared by both halves, only triangles with a corner on the left (x > 0) are
 * selected.
 *
 * @returns undefined if all triangles are to be drawn.
 */
export function drawnTriangles(
  surface: SkinSurface,
  { isMirrored }: UvOverlap,
): ((triangle: number) => boolean) | undefined {
  if (!isMirrored) return undefined
  const { points } = surface
  return (triangle) =>
    !isMirrored[triangle] || cornersOf(surface, triangle).some((point) => points[3 * point] > 0)
}
