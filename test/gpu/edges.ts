import type { Area, WrinkleSet } from 'furrow'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { influenceAt } from './influence-at.ts'

/** Texels of an area's side. */
export const AREA = 8
const LAST = AREA - 1

/** Coordinates at both edges of UV space, and half a texel inside. */
const AT = [0, 0.5 / AREA, 1 - 0.5 / AREA, 1]

/** Side of a square of faces, and of the squares that a face has: one for each point, with its texture coordinates everywhere. */
const SIDE = AT.length

/** A pixel for each point of each face. */
export const PIXELS = SIDE * SIDE

export const FACES = Array.from({ length: SIDE ** 2 }, (_, face) => face)

/** A set with an area whose weight is 1 along all edges, and one with any weights there. */
export function edgeSet(): WrinkleSet {
  const { layers, areas } = randomSet(seeded(7), 2, AREA)
  const isEdge = (i: number) => [i % AREA, Math.floor(i / AREA)].some((at) => at === 0 || at === LAST)
  const weights = {
    ...areas[0].weights,
    data: areas[0].weights.data.map((own, i) => (isEdge(i) ? 255 : own)),
  }
  return { layers, areas: areas.map((area, i): Area => ({ ...area, ...(i === 0 && { weights }) })) }
}

/** Of the two areas: faces beside each other show different ones. */
export function activationsOf(face: number): [number, number] {
  return (face + Math.floor(face / SIDE)) % 2 ? [0, 0.5] : [1, 0]
}

/** Where the centre of a face is in a picture of -1..1; row by row from the bottom. A face is as large as a square of -1..1, divided by `SIDE`. */
export function centreOf(face: number): [number, number] {
  return [middle(face % SIDE), middle(Math.floor(face / SIDE))]
}

export const SCALE = 1 / SIDE

const middle = (i: number) => (2 * i + 1) / SIDE - 1

/** A face's squares: corners in -1..1, texture coordinates, and triangles that are seen from where z is positive. */
export function edgeSquares(): { positions: number[]; uvs: number[]; triangles: number[] } {
  const positions: number[] = []
  const uvs: number[] = []
  const triangles: number[] = []
  for (const [row, v] of AT.entries()) {
    for (const [column, u] of AT.entries()) {
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
 * Largest difference between the influence at all points of all faces and the float64 reference.
 *
 * @param shown influence at a pixel, given its index from the bottom.
 */
export function edgeError({ areas }: WrinkleSet, shown: (pixel: number) => number): number {
  let largest = 0
  for (const face of FACES) {
    const exactAt = influenceAt(areas, activationsOf(face), AREA)
    for (const [row, v] of AT.entries()) {
      for (const [column, u] of AT.entries()) {
        const [x, y] = [(face % SIDE) * SIDE + column, Math.floor(face / SIDE) * SIDE + row]
        largest = Math.max(largest, Math.abs(shown(y * PIXELS + x) - exactAt(u, v)))
      }
    }
  }
  return largest
}
