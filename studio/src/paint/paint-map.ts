import { FurrowError } from 'furrow'
import type { Skin } from 'furrow/author'
import { mapSkin, type SkinSurface, type SkinTexels, type UvGrid, type UvLocator } from 'furrow/internal'
import type { PaintedImage } from './painted.ts'

/** Minimum and maximum width of maps that can be painted, texels. */
const PAINTED_SIDES = [2, 2048] as const

/** Barycentric coordinate below which a texel is outside its triangle. */
const OUTSIDE = -1e-6

/**
 * Texels of a square map on a skin, as arrays that can be transferred between workers. A place is a pair of a texel and a triangle that contains
 * it. A texel has several places if several parts of the skin share it. A texel just beyond a UV island is paired with a triangle at the
 * island's border. Such texels are painted too, because texture filtering reads them at seams.
 */
export interface PaintMapArrays {
  /** Width and height, texels. */
  readonly size: number
  /** Index of each triangle's first place. The places of triangle `t` end before `starts[t + 1]`. */
  readonly starts: Uint32Array
  /** Texel of each place. */
  readonly texels: Uint32Array
  /** Position of each place on the skin as packed xyz, millimetres. */
  readonly positions: Float32Array
  /** 1 for each place whose texel is beyond the UV island, otherwise 0. */
  readonly isBeyondIsland: Uint8Array
  /** Size of a texel on each triangle, millimetres: the square root of the texel's area on the skin. */
  readonly texelSizes: Float32Array
  /** Grid with which `UvLocator` finds the triangle at a UV coordinate. */
  readonly grid: UvGrid
}

/** Texels of a square map on a skin, with a locator. */
export interface PaintMap extends Omit<PaintMapArrays, 'grid'> {
  readonly locator: UvLocator
}

/** @throws FurrowError if the size is not an integer from 2 to 2048. */
export function paintMapArrays(
  skin: Pick<Skin, 'uvs' | 'indices'>,
  surface: SkinSurface,
  size: number,
): PaintMapArrays {
  const [least, most] = PAINTED_SIDES
  if (!(Number.isInteger(size) && size >= least && size <= most)) {
    throw new FurrowError({
      code: 'out-of-range',
      who: 'Studio',
      problem: 'the width of a painted area is invalid',
      value: size,
      limit: `a whole number, ${least} to ${most} texels`,
      remedy: 'resample the area',
    })
  }
  const { texels, locator } = mapSkin(skin, surface, size)
  return {
    size,
    ...findPlaces(texels, surface),
    texelSizes: texelSizes(skin, surface, size),
    grid: locator.grid,
  }
}

function findPlaces(skinTexels: SkinTexels, surface: SkinSurface) {
  const starts = new Uint32Array(surface.skinTriangles.length + 1)
  visitPlaces(skinTexels, (_, triangle) => starts[triangle + 1]++)
  for (let t = 1; t < starts.length; t++) starts[t] += starts[t - 1]
  const count = starts[starts.length - 1]
  const next = starts.slice()
  const texels = new Uint32Array(count)
  const positions = new Float32Array(3 * count)
  const isBeyondIsland = new Uint8Array(count)
  const { points, corners } = surface
  visitPlaces(skinTexels, (texel, triangle, a, b, c) => {
    const place = next[triangle]++
    texels[place] = texel
    isBeyondIsland[place] = Math.min(a, b, c) < OUTSIDE ? 1 : 0
    for (let k = 0; k < 3; k++) {
      positions[3 * place + k] =
        a * points[3 * corners[3 * triangle] + k] +
        b * points[3 * corners[3 * triangle + 1] + k] +
        c * points[3 * corners[3 * triangle + 2] + k]
    }
  })
  return { starts, texels, positions, isBeyondIsland }
}

/** @throws FurrowError if the image is not square or its data is incomplete. */
export function checkPaintable({ width, height, data }: PaintedImage): void {
  if (width === height && data.length === width * height) return
  throw new FurrowError({
    who: 'Studio',
    problem: 'a painted area is not square, or its data is incomplete',
    value: `${width} x ${height} texels, ${data.length} values`,
    remedy: 'resample the area',
  })
}

function visitPlaces(
  texels: SkinTexels,
  visit: (texel: number, triangle: number, a: number, b: number, c: number) => void,
): void {
  texels.visit(visit)
  texels.visitOverlaps(visit)
}

function texelSizes(
  { uvs, indices }: Pick<Skin, 'uvs' | 'indices'>,
  { points, corners, skinTriangles }: SkinSurface,
  size: number,
): Float32Array {
  return Float32Array.from(skinTriangles, (skinTriangle, t) => {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * corners[3 * t + k])
    const [u, v] = [b, c].map((to) => [0, 1, 2].map((k) => points[to + k] - points[a + k]))
    const cross = [0, 1, 2].map((k) => u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3])
    const [i, j, l] = [0, 1, 2].map((k) => 2 * indices[3 * skinTriangle + k])
    const uvArea = Math.abs(
      (uvs[j] - uvs[i]) * (uvs[l + 1] - uvs[i + 1]) - (uvs[l] - uvs[i]) * (uvs[j + 1] - uvs[i + 1]),
    )
    return uvArea > 0 ? Math.sqrt(Math.hypot(...cross) / uvArea) / size : 0
  })
}
