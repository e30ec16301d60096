/**
 * Fills texels outside UV islands, because filtering and mipmaps read them. There are three methods:
 *
 * - `extendPlanes` supplies positions outside the islands, for maps that are computed from positions on the skin. Such maps look the same on
 *   both sides of a UV seam.
 * - `copyNearest` copies the nearest value. It fills the metric (see `Metric`), because a copied metric stays positive definite.
 * - `dilate` averages known neighbours, so that filled texels show no steps. It fills maps that have values only inside the islands, such as
 *   baked maps.
 */

import { length2 } from '../math/vector.ts'

/** Width in texels of the margin around islands in maps without mipmaps. */
export const FILTER_MARGIN = 3
/**
 * Width in texels of the margin around islands in maps with mipmaps. Filtering mipmap level 3 reads up to 12 texels beyond an island. The
 * slopes of these texels depend on heights 2 texels farther away.
 */
export const MIPMAP_MARGIN = 14

/** Triangle edge at the border of an island, in texels. */
export interface BorderEdge {
  triangle: number
  /** Start (x, y), and the vector (dx, dy) from the start to the end. */
  x: number
  y: number
  dx: number
  dy: number
}

/** Maximum number of edges that are shorter than a texel and start in the same texel. More edges would hardly change the result. */
const MAX_SHORT_EDGES = 8
/** The map is divided into blocks of this width and height in texels. An edge skips the blocks whose texels all have a nearer edge. */
const BLOCK = 4
/** Factor that allows for single-precision rounding of a squared distance. */
const ROUNDING = 1.000001

/**
 * Assigns each free texel within `margin` texels of a border edge to the triangle of the nearest edge. The caller extends that triangle's
 * plane to the texel.
 *
 * @param edges returns the border edges; called twice.
 * @param margin maximum distance in texels.
 * @param isFree returns whether a texel may be assigned.
 * @param claim called with the texel and the triangle, and called again for the texel if a later edge is nearer.
 */
export function extendPlanes(
  edges: () => Iterable<BorderEdge>,
  width: number,
  height: number,
  margin: number,
  isFree: (texel: number) => boolean,
  claim: (texel: number, triangle: number) => void,
): void {
  const nearest = new Float32Array(width * height).fill(Infinity)
  const blocks = Math.ceil(width / BLOCK)
  const bounds = distanceBounds(thinned(edges(), width, height), width, height)
  for (const { triangle, x, y, dx, dy } of thinned(edges(), width, height)) {
    const square = dx * dx + dy * dy || 1
    const [left, right] = [Math.min(x, x + dx), Math.max(x, x + dx)]
    const [top, bottom] = [Math.min(y, y + dy), Math.max(y, y + dy)]
    const extend = (texel: number, column: number, row: number) => {
      const along = ((column - x) * dx + (row - y) * dy) / square
      const t = along < 0 ? 0 : along > 1 ? 1 : along
      const offX = column - x - t * dx
      const offY = row - y - t * dy
      // `Math.hypot` would be ten times slower than this test and `length2`.
      if (offX * offX + offY * offY > ROUNDING * nearest[texel] ** 2) return
      const distance = length2(offX, offY)
      if (distance > margin || distance >= nearest[texel]) return
      nearest[texel] = distance
      claim(texel, triangle)
    }
    const [firstColumn, lastColumn] = blocksWithin(left - margin, right + margin, width)
    const [firstRow, lastRow] = blocksWithin(top - margin, bottom + margin, height)
    for (let j = firstRow; j <= lastRow; j++) {
      for (let i = firstColumn; i <= lastColumn; i++) {
        const across = Math.max(0, i * BLOCK - right, left - (i + 1) * BLOCK + 1)
        const up = Math.max(0, j * BLOCK - bottom, top - (j + 1) * BLOCK + 1)
        if (across * across + up * up > bounds[j * blocks + i] ** 2) continue
        const endRow = Math.min((j + 1) * BLOCK, height)
        const endColumn = Math.min((i + 1) * BLOCK, width)
        let farthest = 0
        for (let row = j * BLOCK; row < endRow; row++) {
          for (let column = i * BLOCK; column < endColumn; column++) {
            const texel = row * width + column
            if (!isFree(texel)) continue
            extend(texel, column, row)
            farthest = Math.max(farthest, nearest[texel])
          }
        }
        bounds[j * blocks + i] = Math.min(farthest, bounds[j * blocks + i])
      }
    }
  }
}

/** Returns the indices of the first and last block in a coordinate range. */
function blocksWithin(low: number, high: number, size: number): [first: number, last: number] {
  return [Math.max(Math.floor(low / BLOCK), 0), Math.floor(Math.min(high, size - 1) / BLOCK)]
}

/** Drops edges shorter than a texel if more than `MAX_SHORT_EDGES` of them start in the same texel. */
function* thinned(edges: Iterable<BorderEdge>, width: number, height: number): Generator<BorderEdge> {
  const counts = new Uint8Array(width * height)
  for (const edge of edges) {
    const [column, row] = [Math.round(edge.x), Math.round(edge.y)]
    const isInside = column >= 0 && column < width && row >= 0 && row < height
    if (isInside && edge.dx * edge.dx + edge.dy * edge.dy < 1) {
      if (counts[row * width + column] === MAX_SHORT_EDGES) continue
      counts[row * width + column]++
    }
    yield edge
  }
}

/**
 * Computes, for each block, an upper bound on the distance from its texels to the nearest edge. The bound is the length of a path over
 * neighbouring blocks to a block in which an edge starts (Rosenfeld and Pfaltz 1968, Distance functions on digital pictures).
 */
function distanceBounds(edges: Iterable<BorderEdge>, width: number, height: number): Float32Array {
  const [blocks, rows] = [Math.ceil(width / BLOCK), Math.ceil(height / BLOCK)]
  const bounds = new Float32Array(blocks * rows).fill(Infinity)
  for (const { x, y } of edges) {
    const [column, row] = [Math.floor(Math.round(x) / BLOCK), Math.floor(Math.round(y) / BLOCK)]
    const isInside = column >= 0 && column < blocks && row >= 0 && row < rows
    if (isInside) bounds[row * blocks + column] = Math.SQRT2 * BLOCK
  }
  // Forward pass over the left and upper neighbours, then backward pass over the right and lower neighbours.
  for (const sign of [1, -1]) {
    for (let n = 0; n < bounds.length; n++) {
      const block = sign > 0 ? n : bounds.length - 1 - n
      for (let up = -1; up <= 0; up++) {
        for (let across = -1; across <= (up < 0 ? 1 : -1); across++) {
          const column = (block % blocks) + sign * across
          if (column < 0 || column >= blocks) continue
          // Above the first row and below the last row, `bound` is NaN and the comparison below is false.
          const step = across !== 0 && up !== 0 ? Math.SQRT2 : 1
          const bound = bounds[block + sign * (across + up * blocks)] + step * BLOCK
          if (bound < bounds[block]) bounds[block] = bound
        }
      }
    }
  }
  return bounds
}

/**
 * Copies the value of the nearest known texel to each unknown texel. The search is breadth-first over four neighbours.
 *
 * @param known 1 where a texel has a value.
 * @param width map width in texels.
 * @param maps one value per texel; changed in place.
 */
export function copyNearest(known: Uint8Array, width: number, maps: readonly Float32Array[]): void {
  const reached = known.slice()
  const queue = new Uint32Array(known.length)
  let end = 0
  const pass = (from: number, to: number) => {
    if (reached[to]) return
    reached[to] = 1
    for (const map of maps) map[to] = map[from]
    queue[end++] = to
  }
  const passOn = (from: number) => {
    const column = from % width
    if (column > 0) pass(from, from - 1)
    if (column < width - 1) pass(from, from + 1)
    if (from >= width) pass(from, from - width)
    if (from + width < known.length) pass(from, from + width)
  }
  for (let i = 0; i < known.length; i++) if (known[i]) passOn(i)
  for (let head = 0; head < end; head++) passOn(queue[head])
}

/**
 * Extends values outwards ring by ring, so that filtering and mipmaps show no seams around UV islands. Each new texel gets the mean of its
 * known neighbours (up to eight).
 *
 * @param known 1 where a texel has a value; set to 1 for the texels filled.
 * @param width map width in texels.
 * @param maps `channels` values per texel, interleaved; changed in place.
 * @param rings number of rings to fill, in texels.
 */
export function dilate(
  known: Uint8Array,
  width: number,
  maps: readonly { data: Float32Array; channels: number }[],
  rings: number,
): void {
  const height = known.length / width
  let ring: number[] = []
  for (let i = 0; i < known.length; i++)
    if (!known[i] && hasKnownNeighbour(known, i, width, height)) ring.push(i)
  for (let count = 0; count < rings && ring.length > 0; count++) {
    for (const i of ring) fillFromNeighbours(known, i, width, height, maps)
    for (const i of ring) known[i] = 1
    const next = new Set<number>()
    for (const i of ring) {
      for (const j of neighbours(i, width, height)) if (!known[j]) next.add(j)
    }
    ring = [...next]
  }
}

function fillFromNeighbours(
  known: Uint8Array,
  i: number,
  width: number,
  height: number,
  maps: readonly { data: Float32Array; channels: number }[],
): void {
  const sources = neighbours(i, width, height).filter((j) => known[j])
  for (const { data, channels } of maps) {
    for (let k = 0; k < channels; k++) {
      let sum = 0
      for (const j of sources) sum += data[channels * j + k]
      data[channels * i + k] = sum / sources.length
    }
  }
}

function hasKnownNeighbour(known: Uint8Array, i: number, width: number, height: number): boolean {
  return neighbours(i, width, height).some((j) => known[j])
}

function neighbours(i: number, width: number, height: number): number[] {
  const [column, row] = [i % width, Math.floor(i / width)]
  const found: number[] = []
  for (let y = Math.max(row - 1, 0); y <= Math.min(row + 1, height - 1); y++) {
    for (let x = Math.max(column - 1, 0); x <= Math.min(column + 1, width - 1); x++) {
      if (x !== column || y !== row) found.push(y * width + x)
    }
  }
  return found
}
