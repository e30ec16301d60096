import { cross, dot, length } from '../../../math/vector.ts'
import type { SkinLine } from '../../strokes/curve.ts'

/** Points of a line from one sample to the next. */
const EVERY = 5
/** Distances to a neighbouring line in spacings: nearer ones are pieces of the same line, those farther away have skin of their own. */
const NEAREST = 0.35
const FARTHEST = 1.6
/** Fraction of a line along which it must have a neighbour for its bank to reach there. */
const ALONG = 0.4
/** How far a bank reaches where there is none, in spacings. */
const ALONE = 0.8
/** Neighbours less deep than this, as a fraction of the line's depth, lie on its bank and do not end it. */
const SHALLOW = 0.5

/**
 * How far the banks of lines reach, left and right of each in millimetres: to the neighbouring line, so that both have one bulge of skin in
 * common.
 *
 * @param depths of the lines, to compare them by.
 * @param spacing from line to line, about.
 */
export function bankReaches(
  lines: readonly SkinLine[],
  depths: readonly number[],
  spacing: number,
): [left: number, right: number][] {
  return lines.map((line, index) => {
    const others = lines.filter((_, i) => i !== index && depths[i] >= SHALLOW * depths[index])
    const distances: [number[], number[]] = [[], []]
    let samples = 0
    for (let i = 0; i + 5 < line.points.length; i += 3 * EVERY) {
      samples++
      const nearest = nearestBeside(line, i, others, spacing)
      for (const [side, distance] of nearest.entries()) {
        if (distance <= FARTHEST * spacing) distances[side].push(distance)
      }
    }
    const reachOf = (found: number[]) => (found.length > ALONG * samples ? median(found) : ALONE * spacing)
    return [reachOf(distances[0]), reachOf(distances[1])]
  })
}

/** From a point of a line to the nearest of other lines on its left and on its right. */
function nearestBeside(
  line: SkinLine,
  i: number,
  others: readonly SkinLine[],
  spacing: number,
): [left: number, right: number] {
  const { points, normals } = line
  const along = [0, 1, 2].map((k) => points[i + 3 + k] - points[i + k])
  const right = new Float64Array(3)
  cross(right, along, normals.subarray(i, i + 3))
  const nearest: [number, number] = [Infinity, Infinity]
  for (const other of others) {
    const offset = offsetTo(other, points.subarray(i, i + 3))
    const distance = length(offset)
    if (distance < NEAREST * spacing) continue
    // Beside the line, and not ahead of it.
    const across = dot(offset, right) / (length(right) * distance)
    if (Math.abs(across) < Math.SQRT1_2) continue
    const side = across < 0 ? 0 : 1
    nearest[side] = Math.min(nearest[side], distance)
  }
  return nearest
}

/** From a position to the nearest point of a line. */
function offsetTo({ points }: SkinLine, position: Float64Array): number[] {
  let [nearest, least] = [0, Infinity]
  for (let i = 0; i < points.length; i += 3) {
    const square =
      (points[i] - position[0]) ** 2 + (points[i + 1] - position[1]) ** 2 + (points[i + 2] - position[2]) ** 2
    if (square < least) [nearest, least] = [i, square]
  }
  return [0, 1, 2].map((k) => points[nearest + k] - position[k])
}

function median(values: number[]): number {
  return values.sort((a, b) => a - b)[Math.floor(values.length / 2)]
}
