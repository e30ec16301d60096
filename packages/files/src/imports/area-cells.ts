import type { GrayImage } from 'furrow'

/** Square grid of cells, one per texel of an area: 1 where the cell belongs to a group, else 0. */
export interface Cells {
  side: number
  data: Uint8Array
}

/** Weight of the first ring of cells around an area. Wrinkles fade out there. */
const RING_WEIGHT = 128

/**
 * Returns the largest difference per cell.
 *
 * @param differences one number per texel of a square map.
 * @param side cells per row.
 */
export function largestPerCell(differences: Float32Array, side: number): Float32Array {
  const size = Math.sqrt(differences.length)
  const largest = new Float32Array(side * side)
  for (let i = 0; i < differences.length; i++) {
    const cell = cellOf(i, size, side)
    largest[cell] = Math.max(largest[cell], differences[i])
  }
  return largest
}

/** Returns the cell that contains a texel of a square map. */
export function cellOf(texel: number, size: number, side: number): number {
  const column = Math.floor(((texel % size) * side) / size)
  const row = Math.floor((Math.floor(texel / size) * side) / size)
  return row * side + column
}

/** Adds the cells beside, above, below and diagonal to the group. */
export function grown({ side, data }: Cells, rings = 1): Cells {
  let cells = data
  for (let ring = 0; ring < rings; ring++) {
    const next = cells.slice()
    for (let i = 0; i < cells.length; i++) if (cells[i]) forNeighbours(i, side, (j) => (next[j] = 1))
    cells = next
  }
  return { side, data: cells }
}

/** Splits a group into parts that do not touch. */
export function partsOf({ side, data }: Cells): Cells[] {
  const left = data.slice()
  const parts: Cells[] = []
  for (let start = 0; start < left.length; start++) {
    if (!left[start]) continue
    const part = new Uint8Array(left.length)
    const open = [start]
    left[start] = 0
    while (open.length > 0) {
      const cell = open.pop()!
      part[cell] = 1
      forNeighbours(cell, side, (other) => {
        if (left[other]) open.push(other)
        left[other] = 0
      })
    }
    parts.push({ side, data: part })
  }
  return parts
}

/**
 * Returns the weights of an area that shows a group of cells. The weight is 1 in the group and in one ring around it, so that interpolation
 * between cells gives exactly 1 in the group. Another ring fades out.
 */
export function weightsOfCells(cells: Cells): GrayImage {
  const [full, ring] = [grown(cells), grown(cells, 2)]
  const data = ring.data.map((inRing, i) => (full.data[i] ? 255 : inRing ? RING_WEIGHT : 0))
  return { width: cells.side, height: cells.side, data }
}

/** Returns the cells of a map that an area may show: those with a weight, and one ring around, which interpolation reaches. */
export function shownCells(weights: GrayImage): Cells {
  return grown(weightedCells(weights))
}

/** Returns the cells with a weight above 0. */
export function weightedCells({ width, data }: GrayImage): Cells {
  return { side: width, data: data.map((weight) => (weight > 0 ? 1 : 0)) }
}

export function countOf({ data }: Cells): number {
  return data.reduce((sum, cell) => sum + cell, 0)
}

function forNeighbours(cell: number, side: number, visit: (neighbour: number) => void): void {
  const [x, y] = [cell % side, Math.floor(cell / side)]
  for (let row = Math.max(0, y - 1); row <= Math.min(side - 1, y + 1); row++) {
    for (let column = Math.max(0, x - 1); column <= Math.min(side - 1, x + 1); column++) {
      visit(row * side + column)
    }
  }
}
