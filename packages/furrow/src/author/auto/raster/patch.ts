import { type Skin, type SkinSurface, skinVertices } from '../../skin/surface.ts'

/**
 * Part of a skin: requested triangles and the triangles around them. Its vertices are renumbered from 0, and so are its points. A point is a
 * position, which several vertices share at a UV seam.
 */
export interface Patch {
  /** Indices of the triangles in the surface. The requested triangles come first. */
  triangles: Uint32Array
  /** Number of requested triangles. */
  wanted: number
  /** Points of the surface that the patch uses. */
  points: Uint32Array
  /** Vertices of the skin that the patch uses. */
  vertices: Uint32Array
  /** Index into `points` for each corner of each triangle. */
  corners: Uint32Array
  /** Index into `vertices` for each corner of each triangle. */
  cornerVertices: Uint32Array
}

/**
 * Extracts the requested triangles, and all triangles that share a point with them.
 *
 * @param wanted indices of the requested triangles.
 * @param most maximum number of extracted triangles.
 * @returns undefined if there are more than `most` triangles.
 */
export function patchOf(
  skin: Pick<Skin, 'uvs' | 'indices'>,
  surface: SkinSurface,
  wanted: readonly number[],
  most: number,
): Patch | undefined {
  const { corners, areas } = surface
  const isTouched = new Uint8Array(areas.length)
  const isWanted = new Uint8Array(corners.length / 3)
  for (const triangle of wanted) {
    isWanted[triangle] = 1
    for (let k = 3 * triangle; k < 3 * triangle + 3; k++) isTouched[corners[k]] = 1
  }
  const triangles = [...wanted]
  for (let t = 0; t < isWanted.length; t++) {
    const touches =
      isTouched[corners[3 * t]] || isTouched[corners[3 * t + 1]] || isTouched[corners[3 * t + 2]]
    if (touches && !isWanted[t]) triangles.push(t)
    if (triangles.length > most) return undefined
  }
  const cornerPoints = new Uint32Array(3 * triangles.length)
  const cornerVertices = new Uint32Array(3 * triangles.length)
  for (let i = 0; i < triangles.length; i++) {
    const own = skinVertices(skin, surface, triangles[i])
    for (let k = 0; k < 3; k++) {
      cornerPoints[3 * i + k] = corners[3 * triangles[i] + k]
      cornerVertices[3 * i + k] = own[k]
    }
  }
  const points = renumber(cornerPoints, areas.length)
  const vertices = renumber(cornerVertices, skin.uvs.length / 2)
  return {
    triangles: Uint32Array.from(triangles),
    wanted: wanted.length,
    points: points.used,
    vertices: vertices.used,
    corners: points.indices,
    cornerVertices: vertices.indices,
  }
}

/** Renumbers the indices in a list from 0, in the order in which they first appear. */
function renumber(list: Uint32Array, count: number): { used: Uint32Array; indices: Uint32Array } {
  const numbers = new Int32Array(count).fill(-1)
  const used = new Uint32Array(Math.min(list.length, count))
  const indices = new Uint32Array(list.length)
  let end = 0
  for (let i = 0; i < list.length; i++) {
    const index = list[i]
    if (numbers[index] < 0) {
      used[end] = index
      numbers[index] = end++
    }
    indices[i] = numbers[index]
  }
  return { used: used.slice(0, end), indices }
}
