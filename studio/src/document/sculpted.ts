import type { HeightMap } from 'furrow/author'
import { HEIGHT_STEPS_PER_MM } from 'furrow/internal'

/** Width and height of a tile, texels. */
export const TILE = 64
export const TILE_TEXELS = TILE ** 2
/** Maximum width and height of sculpted heights, texels. Larger maps get resampled ones. */
const MAX_SIZE = 2048

/** Heights of `TILE` x `TILE` texels, row by row, in steps of `HEIGHT_STEPS_PER_MM`. Never changed in place. */
export type SculptedTile = Int16Array

/**
 * Heights that brushes have sculpted on a layer: a square image in tiles. A change replaces only the tiles that it touches, so that undo, saving
 * and drawing handle only these.
 */
export interface Sculpted {
  /** Width and height, texels. */
  readonly size: number
  /** Tiles with heights other than 0. The keys are indices of tiles, row by row. */
  readonly tiles: ReadonlyMap<number, SculptedTile>
}

/** Square image with sculpted heights in steps of `HEIGHT_STEPS_PER_MM`. */
export interface HeightImage {
  readonly width: number
  readonly height: number
  readonly data: Int16Array
}

/** Rectangle of an image, texels. */
export interface Rectangle {
  readonly x: number
  readonly y: number
  readonly width: number
  readonly height: number
}

/** Returns the size of new sculpted heights for maps of `mapSize` texels. */
export function sculptedSize(mapSize: number): number {
  return Math.min(mapSize, MAX_SIZE)
}

/** Returns a copy of sculpted heights as one image. */
export function imageOf({ size, tiles }: Sculpted): HeightImage {
  const data = new Int16Array(size * size)
  for (const [index, tile] of tiles) {
    const { x, y, width, height } = tileRectangle(index, size)
    for (let row = 0; row < height; row++)
      data.set(tile.subarray(row * TILE, row * TILE + width), (y + row) * size + x)
  }
  return { width: size, height: size, data }
}

/** Takes over a rectangle of an image. Keeps the tiles in which nothing changes. Default: the whole image. */
export function withImage(
  { size, tiles }: Sculpted,
  { data }: HeightImage,
  { x, y, width, height }: Rectangle = { x: 0, y: 0, width: size, height: size },
): Sculpted {
  const columns = Math.ceil(size / TILE)
  const next = new Map(tiles)
  for (let row = Math.floor(y / TILE); row * TILE < y + height; row++) {
    for (let column = Math.floor(x / TILE); column * TILE < x + width; column++) {
      const index = row * columns + column
      const tile = tileOf(data, size, index)
      const old = tiles.get(index)
      if (tile.every((value) => value === 0)) next.delete(index)
      else if (!old?.every((value, i) => value === tile[i])) next.set(index, tile)
    }
  }
  return { size, tiles: next }
}

/** Converts sculpted heights to millimetres. */
export function heightMapOf(sculpted: Sculpted): HeightMap {
  const { width, height, data } = imageOf(sculpted)
  return { width, height, data: Float32Array.from(data, (step) => step / HEIGHT_STEPS_PER_MM) }
}

/** Converts a square height map. */
export function sculptedOf({ width, height, data }: HeightMap): Sculpted {
  const steps = Int16Array.from(data, (mm) => Math.round(mm * HEIGHT_STEPS_PER_MM))
  return withImage({ size: width, tiles: new Map() }, { width, height, data: steps })
}

/** Returns the number of tiles of an image with `size` x `size` texels. */
export function tileCount(size: number): number {
  return Math.ceil(size / TILE) ** 2
}

/** Returns the texels of a tile. Tiles at the right and lower borders can be smaller than others. */
export function tileRectangle(index: number, size: number): Rectangle {
  const columns = Math.ceil(size / TILE)
  const [x, y] = [TILE * (index % columns), TILE * Math.floor(index / columns)]
  return { x, y, width: Math.min(TILE, size - x), height: Math.min(TILE, size - y) }
}

function tileOf(data: Int16Array, size: number, index: number): SculptedTile {
  const { x, y, width, height } = tileRectangle(index, size)
  const tile = new Int16Array(TILE_TEXELS)
  for (let row = 0; row < height; row++) {
    const start = (y + row) * size + x
    tile.set(data.subarray(start, start + width), row * TILE)
  }
  return tile
}
