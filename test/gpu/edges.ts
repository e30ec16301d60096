import type { Area, WrinkleSet } from 'furrow'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { influenceAt } from './influence-at.ts'

/** Side of an area, texels. */
export const AREA = 8
const LAST = AREA - 1

/** Coordinates at both edges of UV space, and half a texel inside. */
const POINTS = [0, 0.5 / AREA, 1 - 0.5 / AREA, 1]

/**
 * Number of faces along a side of the picture, and of squares along a side of a face. Each square has the texture coordinates of one point.
 */
const SIDE = POINTS.length

/** One pixel per square of each face. */
export const PIXELS = SIDE * SIDE

export const FACES = Array.from({ length: SIDE ** 2 }, (_, face) => face)

/** Creates a set of two areas: one with weight 1 along all edges, one with random weights. */
export function edgeSet(): WrinkleSet {
  const { layers, areas } = randomSet(seeded(7), 2, AREA)
  const isEdge = (i: number) => [i % AREA, Math.floor(i / AREA)].some((at) => at === 0 || at === LAST)
  const weights = {
    ...areas[0].weights,
    data: areas[0].weights.data.map((own, i) => (isEdge(i) ? 255 : own)),
  }
  return { layers, areas: areas.map((area, i): Area => ({ ...area, ...(i === 0 && { weights }) })) }
}

/** Returns the activations of the two areas. Neighbouring faces show different areas. */
export function activationsOf(face: number): [number, number] {
  return (face + Math.floor(face / SIDE)) % 2 ? [0, 0.5] : [1, 0]
}

/** Returns the centre of a face in a picture of -1..1, row by row from the bottom. Each face is a -1..1 square scaled by `SCALE`. */
export function centreOf(face: number): [number, number] {
  return [middle(face % SIDE), middle(Math.floor(face / SIDE))]
}

export const SCALE = 1 / SIDE

const middle = (i: number) => (2 * i + 1) / SIDE - 1

/** Returns a face's squares: corners in -1..1, texture coordinates, and triangles facing +z. */
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
 * Returns the largest difference between the influence at all points of all faces and the float64 reference.
 *
 * @param shown influence at a pixel index counted from the bottom.
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
