import { type Skin, type SkinSurface, skinVertices } from '../../skin/surface.ts'

/** A few triangles of a skin and those around them, with numbers of their own for points and vertices. */
export interface Patch {
  /** Triangles of the surface: first those that were asked for, in their order. */
  triangles: Uint32Array
  /** How many were asked for. */
  wanted: number
  /** Points of the surface, and vertices of the skin. */
  points: Uint32Array
  vertices: Uint32Array
  /** For each corner of the triangles its index in `points`, and in `vertices`. */
  corners: Uint32Array
  cornerVertices: Uint32Array
}

/**
 * Takes out triangles, and those that have a point in common with any of them.
 *
 * @returns undefined where these are more than `most` together.
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

/** Numbers what is used from 0, in the order in which it comes. */
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
