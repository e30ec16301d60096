import { barycentricsAt, walk } from 'furrow/internal'
import type { PaintMap } from './paint-map.ts'
import type { PaintSkin, SkinPoint } from './paint-skin.ts'
import type { PaintedImage } from './painted.ts'

/** Minimum weight of an outline that stops the fill, 0..255. */
const ENCLOSING = 128
/** Neighbouring texels are connected if their distance on the skin is less than this many texel widths. Skewed UVs stretch texels. */
const MAX_SKEW = 6
/** Index of a missing texel or place. In the code, a place is a pair of a texel and a triangle that contains it; see `PaintMapArrays`. */
const NONE = -1

/**
 * Visits the texels of a flood fill on the skin. The fill crosses UV seams.
 *
 * A weight is low if it is less than `ENCLOSING`, otherwise high. From a low weight, the fill spreads to connected texels with low weights,
 * until a painted outline stops it. The fill also covers the inner edge of the outline, as far as the weight rises. From a high weight, the
 * fill spreads to connected texels with high weights.
 *
 * @param visit called once per texel.
 */
export function visitFilled(
  { surface, skin }: PaintSkin,
  map: PaintMap,
  { data }: PaintedImage,
  start: SkinPoint,
  visit: (texel: number) => void,
): void {
  const { size } = map
  const { placeOf, triangleOf } = firstPlaces(map)
  const [position, direction] = [new Float64Array(3), new Float64Array(3)]
  const weights = new Float64Array(3)

  const texelAt = (triangle: number, at: ArrayLike<number>): number => {
    barycentricsAt(weights, surface, triangle, at)
    const [u, v] = [0, 1].map((k) =>
      [0, 1, 2].reduce((sum, corner) => {
        const vertex = skin.indices[3 * surface.skinTriangles[triangle] + corner]
        return sum + weights[corner] * skin.uvs[2 * vertex + k]
      }, 0),
    )
    const [x, y] = [Math.floor(u * size), Math.floor(v * size)]
    return x >= 0 && y >= 0 && x < size && y < size ? y * size + x : NONE
  }
  /** Returns the texel beside another texel on the skin, or `NONE`. At the border of a UV island, returns a texel across the seam. */
  const neighbourOnSkin = (texel: number, dx: number, dy: number): number => {
    const next = neighbour(texel, dx, dy, size)
    if (next === NONE || placeOf[next] === NONE) return NONE
    const [from, to] = [placeOf[texel], placeOf[next]]
    for (let k = 0; k < 3; k++) {
      position[k] = map.positions[3 * from + k]
      direction[k] = map.positions[3 * to + k] - position[k]
    }
    const distance = Math.hypot(direction[0], direction[1], direction[2])
    if (!(distance < MAX_SKEW * map.texelSizes[triangleOf[from]])) return NONE
    if (map.isBeyondIsland[to] === 0) return next
    // A texel beyond an island is connected only with texels of the island.
    if (map.isBeyondIsland[from] === 1) return NONE
    const triangle = walk(surface, triangleOf[from], position, direction, distance)
    return triangle < 0 ? NONE : texelAt(triangle, position)
  }

  const filled = new Uint8Array(size * size)
  const queue: number[] = []
  const fill = (texel: number) => {
    if (texel === NONE || placeOf[texel] === NONE || filled[texel] === 1) return
    filled[texel] = 1
    queue.push(texel)
  }
  const first = texelAt(start.triangle, start.position)
  const isHigh = first !== NONE && data[first] >= ENCLOSING
  fill(first)
  for (let head = 0; head < queue.length; head++) {
    const texel = queue[head]
    visit(texel)
    for (const [dx, dy] of NEIGHBOURS) {
      const next = neighbourOnSkin(texel, dx, dy)
      if (next === NONE) continue
      const isSame = data[next] >= ENCLOSING === isHigh && data[texel] >= ENCLOSING === isHigh
      const isUphill = data[next] >= ENCLOSING && data[next] >= data[texel]
      if (isSame || isUphill) fill(next)
    }
  }
  visitBeyondIslands(map, placeOf, filled, visit)
}

const NEIGHBOURS = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
] as const

/** Returns the first place of each texel, and the triangle of each place. */
function firstPlaces({ size, starts, texels }: PaintMap) {
  const placeOf = new Int32Array(size * size).fill(NONE)
  const triangleOf = new Uint32Array(texels.length)
  for (let triangle = 0; triangle + 1 < starts.length; triangle++) {
    for (let place = starts[triangle]; place < starts[triangle + 1]; place++) {
      triangleOf[place] = triangle
      if (placeOf[texels[place]] === NONE) placeOf[texels[place]] = place
    }
  }
  return { placeOf, triangleOf }
}

/** Visits the texels beyond UV islands whose nearest island texel is filled. Searches breadth first. */
function visitBeyondIslands(
  { size, isBeyondIsland }: PaintMap,
  placeOf: Int32Array,
  filled: Uint8Array,
  visit: (texel: number) => void,
): void {
  const queue = new Uint32Array(filled.length)
  const isKnown = new Uint8Array(filled.length)
  let count = 0
  for (let texel = 0; texel < filled.length; texel++) {
    if (placeOf[texel] === NONE || isBeyondIsland[placeOf[texel]] === 1) continue
    isKnown[texel] = 1
    queue[count++] = texel
  }
  for (let head = 0; head < count; head++) {
    const texel = queue[head]
    for (const [dx, dy] of NEIGHBOURS) {
      const next = neighbour(texel, dx, dy, size)
      if (next === NONE || isKnown[next] === 1 || placeOf[next] === NONE) continue
      isKnown[next] = 1
      queue[count++] = next
      if (filled[texel] === 0 || filled[next] === 1) continue
      filled[next] = 1
      visit(next)
    }
  }
}

function neighbour(texel: number, dx: number, dy: number, size: number): number {
  const x = (texel % size) + dx
  const y = Math.floor(texel / size) + dy
  return x >= 0 && y >= 0 && x < size && y < size ? y * size + x : NONE
}
