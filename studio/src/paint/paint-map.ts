import { FurrowError, type GrayImage } from 'furrow'
import type { Skin } from 'furrow/author'
import { mapSkin, type SkinSurface, type SkinTexels, type UvGrid, type UvLocator } from 'furrow/internal'

/** Sides of maps that can be painted, in texels. */
const PAINTED_SIDES = [2, 1024] as const

/** Barycentric coordinate below which a texel is beyond the edge of its triangle. */
const OUTSIDE = -1e-6

/**
 * The texels of a square map by the triangles that they are on, as arrays that a worker can hand over. A texel has several places where parts
 * of the skin use it, and texels beyond a UV island have one where the island's border triangle continues, so that filtering finds the same on
 * both sides of a seam.
 */
export interface PaintMapArrays {
  /** Side in texels. */
  readonly size: number
  /** The places on triangle t: from `starts[t]` to `starts[t + 1]`. */
  readonly starts: Uint32Array
  /** Of each place, and x, y and z of where it is on the skin, in millimetres. */
  readonly texels: Uint32Array
  readonly positions: Float32Array
  /** 1 where a place is beyond an island. */
  readonly isBeyond: Uint8Array
  /** Side of a texel on each triangle, in millimetres: the square root of its area. */
  readonly texelSizes: Float32Array
  /** Of its locator. */
  readonly grid: UvGrid
}

/** A map that is painted. */
export interface PaintMap extends Omit<PaintMapArrays, 'grid'> {
  readonly locator: UvLocator
}

/** @throws FurrowError when the size is not a whole number from 2 to 1024. */
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
      problem: 'side of an area that is painted',
      value: size,
      limit: `${least} to ${most} texels`,
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

/** The texels of each triangle, and where they are. */
function findPlaces(skinTexels: SkinTexels, surface: SkinSurface) {
  const starts = new Uint32Array(surface.skinTriangles.length + 1)
  visitPlaces(skinTexels, (_, triangle) => starts[triangle + 1]++)
  for (let t = 1; t < starts.length; t++) starts[t] += starts[t - 1]
  const count = starts[starts.length - 1]
  const next = starts.slice()
  const texels = new Uint32Array(count)
  const positions = new Float32Array(3 * count)
  const isBeyond = new Uint8Array(count)
  const { points, corners } = surface
  visitPlaces(skinTexels, (texel, triangle, a, b, c) => {
    const place = next[triangle]++
    texels[place] = texel
    isBeyond[place] = Math.min(a, b, c) < OUTSIDE ? 1 : 0
    for (let k = 0; k < 3; k++) {
      positions[3 * place + k] =
        a * points[3 * corners[3 * triangle] + k] +
        b * points[3 * corners[3 * triangle + 1] + k] +
        c * points[3 * corners[3 * triangle + 2] + k]
    }
  })
  return { starts, texels, positions, isBeyond }
}

/** @throws FurrowError when an area is not square, or its data incomplete. */
export function checkPaintable({ width, height, data }: GrayImage): void {
  if (width === height && data.length === width * height) return
  throw new FurrowError({
    who: 'Studio',
    problem: 'an area that is painted is not square',
    value: `${width} x ${height} texels, ${data.length} bytes`,
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
