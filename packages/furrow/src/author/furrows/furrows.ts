import { hash32 } from '../../math/hash.ts'
import { smoothstep } from '../../math/scalar.ts'
import { length2, length3 } from '../../math/vector.ts'
import type { Metric } from '../metric.ts'
import type { SkinCanvas } from '../skin/canvas.ts'
import { layCurve, type SkinLine } from '../strokes/curve.ts'
import type { Stroke } from '../strokes/document.ts'
import type { HeightMap } from '../strokes/height.ts'
import { isBulge } from '../strokes/lay-out.ts'
import { valleyAt } from '../strokes/profile.ts'
import { directionsAlong, TENSOR } from './direction-field.ts'
import { LocalCells } from './local-cells.ts'
import type { Furrows } from './read-furrows.ts'
import { FURROW_WIDTH, type Seeds, scatterSeeds, squareBy } from './scatter.ts'
import { SeedGrid } from './seed-grid.ts'

/** Levels of the furrow pattern, from coarse to fine. `size` and `depth` are factors on the pattern's cell size and depth. */
const LEVELS = [
  { size: 1, depth: 1 },
  { size: 0.45, depth: 0.45 },
] as const
const SOFTNESS = 0.5
/** Width in texels below which furrows are skipped. */
export const MIN_TEXELS = 1.7
/** Width in texels from which furrows have their full depth. */
const FULL_TEXELS = 2.2
/** Search radius in cell sizes. There are always three seeds (centres of cells) within this distance. */
const REACH = 2.2

/** Maximum random reduction of a furrow's depth, as a fraction. */
const UNEVEN = 0.85
/** Maximum reduction of the depth of furrows that cross nearby wrinkle lines, as a fraction. */
const ACROSS = 0.9

type FurrowCanvas = Pick<SkinCanvas, 'surface' | 'texels' | 'metric' | 'locator'>

/**
 * Draws a pattern of fine, crossing furrows on the skin (Bando, Kuratate and Nishita 2002, A simple method for modeling wrinkles on human
 * skin). Furrows are the borders between the cells of a cellular texture (Worley 1996, A cellular texture basis function). A second, finer
 * cellular texture divides the cells. Cells are stretched along nearby wrinkle lines.
 *
 * The pattern is defined in 3D, so UV seams do not show. Furrows narrower than about two texels are skipped.
 *
 * @param lines wrinkle lines on the skin, in millimetres. Far from lines, cells are not stretched.
 */
export function furrowHeights(
  canvas: FurrowCanvas,
  furrows: Furrows,
  lines: readonly SkinLine[] = [],
): HeightMap {
  const { surface, texels, metric } = canvas
  const { width, height } = metric
  const data = new Float32Array(width * height)
  const directions = directionsAlong(surface, lines)
  const cells = new LocalCells(furrows, canvas)
  const { stretch } = furrows
  const texelSizes = texelSizesOf(canvas)
  const visible = (triangle: number, furrow: number) => resolved(furrow, texelSizes[triangle])
  for (const [level, { size: part, depth }] of LEVELS.entries()) {
    const seed = furrows.seed + level
    const pen = new FurrowPen(
      scatterSeeds({ surface, directions, cells, stretch, seed, part, visible }),
      stretch,
    )
    texels.visitNear(pen.isNear, (texel, position) => {
      cells.find(position[0], position[1], position[2])
      if (cells.depth > 0) data[texel] = Math.min(data[texel], -depth * cells.depth * pen.depthAt(position))
    })
  }
  return { width, height, data }
}

/** Adds a pattern of fine furrows to a height map. The cells of the pattern are stretched along the strokes (wrinkles), but not along bulges. */
export function addFurrows(
  heights: HeightMap,
  canvas: SkinCanvas,
  furrows: Furrows,
  strokes: readonly Stroke[],
): void {
  const { data } = furrowHeights(
    canvas,
    furrows,
    strokes.filter((stroke) => !isBulge(stroke)).flatMap((stroke) => layCurve(stroke, canvas)),
  )
  for (let i = 0; i < data.length; i++) heights.data[i] += data[i]
}

/** Returns how visible a furrow is, 0..1. Both parameters are in millimetres. */
function resolved(width: number, texelSize: number): number {
  return smoothstep((width / texelSize - MIN_TEXELS) / (FULL_TEXELS - MIN_TEXELS))
}

/** Returns the texel size of each triangle in millimetres, measured along the edge with the largest texels. */
function texelSizesOf({ surface, locator, metric }: FurrowCanvas): Float64Array {
  const sizes = new Float64Array(surface.skinTriangles.length)
  const corners = [0, 1, 2].map((k) => Float64Array.from([0, 1, 2], (n) => (n === k ? 1 : 0)))
  for (const triangle of sizes.keys()) {
    const uvs = corners.map((corner) => locator.uvAt(triangle, corner))
    for (let k = 0; k < 3; k++) {
      const [from, to] = [uvs[k], uvs[(k + 1) % 3]]
      const length = edgeLength(
        surface.points,
        surface.corners,
        3 * triangle + k,
        3 * triangle + ((k + 1) % 3),
      )
      const texels = texelsBetween(from, to, metric)
      sizes[triangle] = Math.max(sizes[triangle], length / texels)
    }
  }
  return sizes
}

/** Returns the number of texels between two UV points, but at most `width + height`, because repeats of the texture have the same texels. */
function texelsBetween(from: readonly number[], to: readonly number[], { width, height }: Metric): number {
  return Math.min(length2((to[0] - from[0]) * width, (to[1] - from[1]) * height), width + height)
}

function edgeLength(points: Float64Array, corners: Uint32Array, from: number, to: number): number {
  const [a, b] = [3 * corners[from], 3 * corners[to]]
  return length3(points[b] - points[a], points[b + 1] - points[a + 1], points[b + 2] - points[a + 2])
}

/** Offsets in a seed's record in `FurrowPen`. The record starts with the distance from the tile's centre, the position and the metric. */
const [SIZE, SCALE, VISIBLE, HASH] = [4 + TENSOR, 5 + TENSOR, 6 + TENSOR, 7 + TENSOR]
/** Count of numbers in a seed's record. */
const SEED = 8 + TENSOR

/** Draws one level of a furrow pattern, tile by tile (see `SkinTexels`). A seed is the centre of a cell. */
class FurrowPen {
  readonly #seeds: Seeds
  readonly #grid: SeedGrid
  /** Search radius around a tile, in millimetres. */
  readonly #reach: number
  /** Centre of the current tile. */
  readonly #middle = new Float64Array(3)
  /** Seeds near the current tile, nearest first. */
  #tile = new Float64Array(64 * SEED)
  #count = 0

  constructor(seeds: Seeds, stretch: number) {
    this.#seeds = seeds
    this.#reach = REACH * stretch * seeds.sizes.reduce((largest, size) => Math.max(largest, size), 0.1)
    this.#grid = new SeedGrid(seeds.positions, this.#reach)
    for (const index of seeds.sizes.keys()) this.#grid.add(index)
  }

  /** Collects the seeds near a tile's bounding box, for `depthAt` at positions in this box. Returns whether it found at least three. */
  readonly isNear = (low: Float64Array, high: Float64Array): boolean => {
    this.#count = 0
    if (low[0] > high[0]) return false
    const { positions, metrics } = this.#seeds
    const middle = this.#middle
    let square = 0
    for (let k = 0; k < 3; k++) {
      middle[k] = (low[k] + high[k]) / 2
      square += (high[k] - low[k]) ** 2
    }
    const [x, y, z] = middle
    const found = this.#grid.search(low, high, this.#reach)
    const distances = new Float64Array(found.length)
    let [nearest, second, third] = [Infinity, Infinity, Infinity]
    for (let n = 0; n < found.length; n++) {
      const [seed, i] = [3 * found[n], TENSOR * found[n]]
      const away = squareBy(metrics, i, positions[seed] - x, positions[seed + 1] - y, positions[seed + 2] - z)
      const distance = Math.sqrt(away)
      distances[n] = distance
      if (distance < third) third = distance
      if (third < second) [second, third] = [third, second]
      if (second < nearest) [nearest, second] = [second, nearest]
    }
    // The metric of a seed never lengthens a distance. So the seed's distances to the centre and to a position in the box differ by at most half
    // the diagonal. Therefore the three seeds nearest to a position are at most `third` plus the whole diagonal from the centre.
    const farthest = third + Math.sqrt(square)
    const near = [...distances.keys()].filter((n) => distances[n] <= farthest)
    near.sort((a, b) => distances[a] - distances[b])
    if (near.length * SEED > this.#tile.length) this.#tile = new Float64Array(2 * near.length * SEED)
    for (const n of near) this.#addToTile(found[n], distances[n])
    return this.#count > 2
  }

  #addToTile(index: number, distance: number): void {
    const { positions, metrics, sizes, scales, visible, hashes } = this.#seeds
    const tile = this.#tile
    const first = SEED * this.#count++
    tile[first] = distance
    for (let k = 0; k < 3; k++) tile[first + 1 + k] = positions[3 * index + k]
    for (let k = 0; k < TENSOR; k++) tile[first + 4 + k] = metrics[TENSOR * index + k]
    tile[first + SIZE] = sizes[index]
    tile[first + SCALE] = scales[index]
    tile[first + VISIBLE] = visible[index]
    tile[first + HASH] = hashes[index]
  }

  /**
   * Returns the depth at a position of the tile, as a fraction of the pattern's depth, 0..1. It is the depth of the deepest furrow between
   * the cells of the three nearest seeds. A position's distance to the border between two cells is half the difference between its distances
   * to the two seeds.
   */
  depthAt(position: Float64Array): number {
    const tile = this.#tile
    const [x, y, z] = position
    const off = length3(x - this.#middle[0], y - this.#middle[1], z - this.#middle[2])
    let [nearest, second, third] = [Infinity, Infinity, Infinity]
    let [a, b, c] = [0, 0, 0]
    const end = SEED * this.#count
    for (let i = 0; i < end; i += SEED) {
      const least = tile[i] - off
      if (least > 0 && least * least >= third) break
      const square = squareBy(tile, i + 4, tile[i + 1] - x, tile[i + 2] - y, tile[i + 3] - z)
      if (square >= third) continue
      ;[third, c] = [square, i]
      if (third < second) [second, b, third, c] = [third, c, second, b]
      if (second < nearest) [nearest, a, second, b] = [second, b, nearest, a]
    }
    // A furrow must have the same width in both cells, so average the widths of both seeds.
    const width = (seed: number) => FURROW_WIDTH * tile[seed + SCALE] * tile[seed + SIZE]
    const halfWidth = (width(a) + width(b)) / 4
    const visible = (tile[a + VISIBLE] + tile[b + VISIBLE]) / 2
    const valley = (square: number) =>
      valleyAt((Math.sqrt(square) - Math.sqrt(nearest)) / 2 / halfWidth, SOFTNESS)
    const own = this.#strength(a, b) * valley(second)
    // Where a shallow furrow ends at a deeper one, use the deeper one.
    const next = valley(third)
    return (
      visible *
      (next > own ? Math.max(own, next * Math.max(this.#strength(a, c), this.#strength(b, c))) : own)
    )
  }

  /** Returns the depth of the furrow between two seeds, 0..1. It is random, and smaller if the furrow crosses nearby wrinkle lines. */
  #strength(a: number, b: number): number {
    const tile = this.#tile
    const [dx, dy, dz] = [tile[b + 1] - tile[a + 1], tile[b + 2] - tile[a + 2], tile[b + 3] - tile[a + 3]]
    const square = dx * dx + dy * dy + dz * dz
    // Squared distance between both seeds, measured with the metric of one seed. It is smaller along wrinkle lines than across them. The
    // division removes the seed's random factor from its metric.
    const across = (seed: number) => squareBy(tile, seed + 4, dx, dy, dz) / tile[seed + SCALE] ** 2
    const along = 2 * square - across(a) - across(b)
    const random = hash32(tile[a + HASH] ^ tile[b + HASH]) / 2 ** 32
    return (1 - UNEVEN * random) * (1 - (ACROSS * along) / (2 * square))
  }
}
