/**
 * Numbers the points of a mesh: vertices with the same position at rest share one.
 *
 * @param positions x, y and z of each vertex.
 * @returns the point of each vertex, and how many points there are.
 */
export function weldVertices(positions: ArrayLike<number>): { pointOf: Uint32Array; count: number } {
  const vertices = Math.floor(positions.length / 3)
  const pointOf = new Uint32Array(vertices)
  /** The first vertex of each point. */
  const firstOf = new Uint32Array(vertices)
  /** Points by the hash of their position, from 1; where it is taken, by the next one that is free. */
  const slots = new Uint32Array(2 ** Math.ceil(Math.log2(2 * vertices + 2)))
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
    // NaN is the same as NaN, and -0 as 0.
    if (!Object.is(positions[3 * i + k] + 0, positions[3 * j + k] + 0)) return false
  }
  return true
}

const number = new Float64Array(1)
const bits = new Uint32Array(number.buffer)

/** FNV-1a over words of 32 bits, with the last step of MurmurHash 3. */
function hash(positions: ArrayLike<number>, vertex: number): number {
  let h = 0x811c9dc5
  for (let k = 3 * vertex; k < 3 * vertex + 3; k++) {
    // -0 is 0.
    number[0] = positions[k] + 0
    h = Math.imul(h ^ bits[0], 0x01000193)
    h = Math.imul(h ^ bits[1], 0x01000193)
  }
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b)
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35)
  return (h ^ (h >>> 16)) >>> 0
}
