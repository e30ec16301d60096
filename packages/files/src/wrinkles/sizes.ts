/**
 * GPU memory of a texture in three encodings, bytes. A texture contains either a map (four channels) or the weights of
 * an area (one channel). For slices of texture arrays, which contain up to four areas, see `areaSliceSizes`.
 */
export interface GpuSizes {
  /** Without compression: 4 bytes per texel of a map, 1 byte per texel of an area. */
  uncompressed: number
  /** BC7 or ASTC 4x4: 8 bits per texel of a map. BC4: 4 bits per texel of an area. */
  bits8: number
  /** BC1 or ETC1: 4 bits per texel of a map. BC4: 4 bits per texel of an area. */
  bits4: number
}

/** Sizes of a map that is not uploaded. */
export const NO_SIZES: GpuSizes = { uncompressed: 0, bits8: 0, bits4: 0 }

/** Returns the sizes of a map: four channels, with mipmaps. */
export function mapSizes(width: number, height: number): GpuSizes {
  return {
    uncompressed: sumLevels(width, height, (w, h) => 4 * w * h),
    bits8: sumLevels(width, height, (w, h) => 16 * blocks(w, h)),
    bits4: sumLevels(width, height, (w, h) => 8 * blocks(w, h)),
  }
}

/** Returns the sizes of an area: one channel, without mipmaps, which would bleed across UV islands. */
export function areaSizes(width: number, height: number): GpuSizes {
  const compressed = 8 * blocks(width, height)
  return { uncompressed: width * height, bits8: compressed, bits4: compressed }
}

/**
 * Returns the sizes of a slice of a texture array. The slice contains up to four areas, one per channel. Compressed
 * slices have 8 bits per texel. There are no mipmaps.
 */
export function areaSliceSizes(width: number, height: number): GpuSizes {
  const compressed = 16 * blocks(width, height)
  return { uncompressed: 4 * width * height, bits8: compressed, bits4: compressed }
}

/** Bytes per texel of an influence map for 1 to 4 layers: one float, two floats, or four half floats. */
const INFLUENCE_TEXEL = [4, 8, 8, 8]

/**
 * Returns the bytes of a face's influence map (per layer, the sum of areas times activations).
 *
 * @param width width of the areas, texels.
 * @param height height of the areas, texels.
 */
export function influenceMapBytes(width: number, height: number, layers: number): number {
  return INFLUENCE_TEXEL[layers - 1] * width * height
}

export function sumSizes(sizes: readonly GpuSizes[]): GpuSizes {
  const sum = (key: keyof GpuSizes) => sizes.reduce((total, size) => total + size[key], 0)
  return { uncompressed: sum('uncompressed'), bits8: sum('bits8'), bits4: sum('bits4') }
}

/** Formats a size in units of 1024 bytes. */
export function kilobytes(bytes: number): string {
  return `${(bytes / 1024).toFixed(bytes < 100 * 1024 ? 1 : 0)} kB`
}

function blocks(width: number, height: number): number {
  return Math.ceil(width / 4) * Math.ceil(height / 4)
}

function sumLevels(width: number, height: number, bytes: (w: number, h: number) => number): number {
  const last = width === 1 && height === 1
  const half = (side: number) => Math.max(1, Math.floor(side / 2))
  return bytes(width, height) + (last ? 0 : sumLevels(half(width), half(height), bytes))
}
