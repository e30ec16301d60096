import type { Area, WrinkleSet } from 'furrow'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { influenceAt } from './influence-at.ts'

/** Width and height of an area, texels. */
export const AREA = 8
const LAST = AREA - 1

/** Texture coordinates to test, in u and in v: both edges of UV space, and half a texel inside each edge. */
const POINTS = [0, 0.5 / AREA, 1 - 0.5 / AREA, 1]

/** Faces per row of the picture, and squares per row of a face. A face is a grid of squares. Each square shows one point of the texture. */
const SIDE = POINTS.length

/** Width and height of the picture: one pixel per square of each face. */
export const PIXELS = SIDE * SIDE

export const FACES = Array.from({ length: SIDE ** 2 }, (_, face) => face)

/** Creates a wrinkle set with two areas of random weights. The first area has weight 1 in all border texels. */
export function edgeSet(): WrinkleSet {
  const { layers, areas } = randomSet(seeded(7), 2, AREA)
  const isEdge = (i: number) => [i % AREA, Math.floor(i / AREA)].some((at) => at === 0 || at === LAST)
  const weights = {
    ...areas[0].weights,
    data: areas[0].weights.data.map((own, i) => (isEdge(i) ? 255 : own)),
  }
  return { layers, areas: areas.map((area, i): Area => ({ ...area, ...(i === 0 && { weights }) })) }
}

/** Returns the activations of the two areas on a face. Neighbouring faces show different areas. */
export function activationsOf(face: number): [number, number] {
  return (face + Math.floor(face / SIDE)) % 2 ? [0, 0.5] : [1, 0]
}

/** Returns the centre of a face in clip space. Faces fill the picture row by row from the bottom, each 2 * `SCALE` wide. */
export function centreOf(face: number): [number, number] {
  return [middle(face % SIDE), middle(Math.floor(face / SIDE))]
}

export const SCALE = 1 / SIDE

const middle = (i: number) => (2 * i + 1) / SIDE - 1

/** Returns the geometry of a face in -1..1: the corners of its squares, their texture coordinates, and triangles that face +z. */
export function edgeSquares(): { positions: number[]; uvs: number[]; triangles: number[] } {
  const positions: number[] = []
  const uvs: number[] = []
  const triangles: number[] = []
  for (const [row, v] of POINTS.entries()) {
    for (const [column, u] of POINTS.entries()) {
      const first = uvs.length / 2
      triangles.push(...[0, 1, 2, 2, 1, 3].map((corner) => first + corner))
      for (const [x, y] of CORNERS) {
        positions.push(middle(column) + x * SCALE, middle(row) + y * SCALE, 0)
        uvs.push(u, v)
      }
    }
  }
  return { positions, uvs, triangles }
}

const CORNERS = [
  [-1, -1],
  [1, -1],
  [-1, 1],
  [1, 1],
] as const

/**
 * Compares the influence at all points of all faces with the float64 reference. Returns the largest difference.
 *
 * @param shown returns the drawn influence at a pixel index. Indices start at the bottom row.
 */
export function edgeError({ areas }: WrinkleSet, shown: (pixel: number) => number): number {
  let largest = 0
  for (const face of FACES) {
    const exactAt = influenceAt(areas, activationsOf(face), AREA)
    for (const [row, v] of POINTS.entries()) {
      for (const [column, u] of POINTS.entries()) {
        const [x, y] = [(face % SIDE) * SIDE + column, Math.floor(face / SIDE) * SIDE + row]
        largest = Math.max(largest, Math.abs(shown(y * PIXELS + x) - exactAt(u, v)))
      }
    }
  }
  return largest
}
