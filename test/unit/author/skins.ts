import type { MetricMesh, Stroke } from 'furrow/author'
import { STROKE_DEFAULTS } from '../../../packages/furrow/src/author/strokes/document.ts'

/** Radius and height of the cylinder, millimetres. */
export const RADIUS = 20
export const HEIGHT = 60
/** Number of quads around the cylinder. */
const COLUMNS = 96

/**
 * Returns a cylinder around the y axis with two UV islands. Both seams are at z = 0, one at -x and one at +x. The front (z > 0) is on the left
 * of the texture. The back is on the right, upside down.
 */
export function cylinder(): MetricMesh {
  const [positions, uvs, indices]: number[][] = [[], [], []]
  for (const [half, [u0, turned]] of [[0.05, false] as const, [0.55, true] as const].entries()) {
    const first = positions.length / 3
    for (let row = 0; row <= 12; row++) {
      for (let column = 0; column <= COLUMNS / 2; column++) {
        // The angle runs from -x over the front to +x. For the second island, it continues over the back to -x.
        const angle = Math.PI * (half - column / (COLUMNS / 2) + 1)
        const [along, up] = [column / (COLUMNS / 2), row / 12]
        positions.push(RADIUS * Math.cos(angle), HEIGHT * up, RADIUS * Math.sin(angle))
        uvs.push(u0 + 0.4 * (turned ? 1 - along : along), turned ? 0.1 + 0.8 * up : 0.9 - 0.8 * up)
        const i = first + row * (COLUMNS / 2 + 1) + column
        const above = i + COLUMNS / 2 + 1
        if (row < 12 && column < COLUMNS / 2) indices.push(i, i + 1, above + 1, i, above + 1, above)
      }
    }
  }
  return { positions: positions.map((value) => Math.round(1e6 * value) / 1e9), uvs, indices }
}

/** Returns the UV of a point: `turn` is the angle from -x in half turns, 0..2, and `y` the height in millimetres. */
export function uvOf(turn: number, y: number): [number, number] {
  return turn <= 1
    ? [0.05 + 0.4 * turn, 0.9 - (0.8 * y) / HEIGHT]
    : [0.95 - 0.4 * (turn - 1), 0.1 + (0.8 * y) / HEIGHT]
}

/** Returns a stroke through points of the cylinder. */
export function strokeOn(
  points: readonly (readonly [turn: number, y: number])[],
  more: Partial<Stroke> = {},
): Stroke {
  const uvs = points.map(([turn, y]) => uvOf(turn, y))
  return { ...STROKE_DEFAULTS, curve: 'spline', points: uvs, width: 2, depth: 1, ...more }
}

/** Returns the turn and the height of a point of the cylinder, from its UV coordinates. */
export function placeOf([u, v]: readonly [number, number]): [turn: number, y: number] {
  return u < 0.5
    ? [(u - 0.05) / 0.4, ((0.9 - v) * HEIGHT) / 0.8]
    : [1 + (0.95 - u) / 0.4, ((v - 0.1) * HEIGHT) / 0.8]
}

/** Returns a sheet of 100 x 50 mm whose left and right half share texels: the UV layout is folded at x = 0. */
export function folded(): MetricMesh {
  const [positions, uvs, indices]: number[][] = [[], [], []]
  for (let row = 0; row <= 4; row++) {
    for (let column = 0; column <= 8; column++) {
      positions.push((column - 4) / 80, row / 80, 0)
      uvs.push(0.1 + Math.abs(column - 4) / 5, 0.9 - row / 5)
      const i = 9 * row + column
      if (row < 4 && column < 8) indices.push(i, i + 1, i + 10, i, i + 10, i + 9)
    }
  }
  return { positions, uvs, indices }
}
