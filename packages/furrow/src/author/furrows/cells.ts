import { hash32 } from '../../math/hash.ts'

/** Cells of the lattice round that of a position whose seeds may be the nearest: their offsets, the nearest first. */
const AROUND = Int8Array.from(offsetsWithin(2).flat())
/** Half the side of the cube, in cells, in which the seed of a cell lies round its middle. */
const JITTER = 0.45

/** A symmetric matrix of a metric: xx, yy, zz, xy, xz, yz. */
export type MetricTensor = ArrayLike<number>

/**
 * Distance from a position to the border between the cells of two seeds, of a cellular pattern in space (Worley 1996, A cellular texture basis
 * function): half the difference of the distances to the nearest two. Seeds lie in a jittered cubic lattice. What is evaluated on a surface
 * knows nothing of its texture, so that its seams do not show.
 *
 * @param size side of a cell of the lattice; the distance is in its unit.
 * @param metric by which squares of distances are measured: cells are long where they count less.
 * @param least how much less they count at most, 0.25..1.
 */
export function borderDistance(
  x: number,
  y: number,
  z: number,
  size: number,
  seed: number,
  metric: MetricTensor,
  least: number,
): number {
  const [px, py, pz] = [x / size, y / size, z / size]
  const [i, j, k] = [Math.floor(px), Math.floor(py), Math.floor(pz)]
  let [nearest, second] = [Infinity, Infinity]
  for (let n = 0; n < AROUND.length; n += 3) {
    const [a, b, c] = [i + AROUND[n], j + AROUND[n + 1], k + AROUND[n + 2]]
    const [mx, my, mz] = [outside(px - a), outside(py - b), outside(pz - c)]
    if (least * (mx * mx + my * my + mz * mz) >= second) continue
    const hash = hash32(Math.imul(a, 0x8da6b343) ^ Math.imul(b, 0xd8163841) ^ Math.imul(c, 0xcb1ab31f) ^ seed)
    const dx = a + jittered(hash & 1023) - px
    const dy = b + jittered((hash >>> 10) & 1023) - py
    const dz = c + jittered((hash >>> 20) & 1023) - pz
    const square =
      metric[0] * dx * dx +
      metric[1] * dy * dy +
      metric[2] * dz * dz +
      2 * (metric[3] * dx * dy + metric[4] * dx * dz + metric[5] * dy * dz)
    if (square < nearest) [nearest, second] = [square, nearest]
    else if (square < second) second = square
  }
  return (size * (Math.sqrt(second) - Math.sqrt(nearest))) / 2
}

/** From a coordinate to where seeds of a cell, which is from 0 to 1, may be. */
function outside(x: number): number {
  const away = Math.abs(x - 0.5) - JITTER
  return away > 0 ? away : 0
}

/** Offsets of up to `reach` along each axis, sorted by their length. */
function offsetsWithin(reach: number): number[][] {
  const range = Array.from({ length: 2 * reach + 1 }, (_, i) => i - reach)
  return range
    .flatMap((x) => range.flatMap((y) => range.map((z) => [x, y, z])))
    .sort((a, b) => Math.hypot(...a) - Math.hypot(...b))
}

/** 0.5 - JITTER to 0.5 + JITTER from 10 random bits. */
function jittered(bits: number): number {
  return 0.5 + JITTER * (bits / 511.5 - 1)
}
