import { powerOfTwoFrom } from './scalar.ts'

/**
 * Welds vertices: all vertices with the same position form one point.
 *
 * @param positions packed xyz per vertex, in the rest pose.
 * @returns `pointOf` contains the index of the point of each vertex, and `count` is the number of points.
 */
export function weldVertices(positions: ArrayLike<number>): { pointOf: Uint32Array; count: number } {
  const vertices = Math.floor(positions.length / 3)
  const pointOf = new Uint32Array(vertices)
  /** First vertex of each point. */
  const firstOf = new Uint32Array(vertices)
  /** Hash table of points, with linear probing. A slot stores 1 plus the index of a point, or 0 if it is free. */
  const slots = new Uint32Array(powerOfTwoFrom(2 * vertices + 2))
  const mask = slots.length - 1
  let count = 0
  for (let i = 0; i < vertices; i++) {
    let slot = hash(positions, i) & mask
    while (slots[slot] > 0 && !isSame(positions, firstOf[slots[slot] - 1], i)) slot = (slot + 1) & mask
    if (slots[slot] === 0) {
      firstOf[count] = i
      slots[slot] = ++count
    }
    pointOf[i] = slots[slot] - 1
  }
  return { pointOf, count }
}

function isSame(positions: ArrayLike<number>, i: number, j: number): boolean {
  for (let k = 0; k < 3; k++) {
    // NaN counts as equal to NaN, and -0 as equal to 0.
    if (!Object.is(positions[3 * i + k] + 0, positions[3 * j + k] + 0)) return false
  }
  return true
}

const number = new Float64Array(1)
const bits = new Uint32Array(number.buffer)

/** Hashes a position by FNV-1a over 32-bit words, followed by the finaliser of MurmurHash3. */
function hash(positions: ArrayLike<number>, vertex: number): number {
  let h = 0x811c9dc5
  for (let k = 3 * vertex; k < 3 * vertex + 3; k++) {
    // Adding 0 turns -0 into 0.
    number[0] = positions[k] + 0
    h = Math.imul(h ^ bits[0], 0x01000193)
    h = Math.imul(h ^ bits[1], 0x01000193)
  }
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b)
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35)
  return (h ^ (h >>> 16)) >>> 0
}
