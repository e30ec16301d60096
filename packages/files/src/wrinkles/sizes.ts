/** Bytes of one texture on the GPU. */
export interface GpuSizes {
  /** 4 bytes per texel of a layer's map, 1 byte per texel of an area's weights. */
  uncompressed: number
  /** 8 bits per texel in blocks of 4 x 4: BC7, ASTC 4x4; 4 bits for an area (BC4). */
  bits8: number
  /** 4 bits per texel in blocks of 4 x 4: BC1, ETC1; BC4 for an area. */
  bits4: number
}

/** Sizes of data that is never uploaded. */
export const NO_SIZES: GpuSizes = { uncompressed: 0, bits8: 0, bits4: 0 }

/** Sizes of a map: four channels, with mipmaps. */
export function mapSizes(width: number, height: number): GpuSizes {
  return {
    uncompressed: sumLevels(width, height, (w, h) => 4 * w * h),
    bits8: sumLevels(width, height, (w, h) => 16 * blocks(w, h)),
    bits4: sumLevels(width, height, (w, h) => 8 * blocks(w, h)),
  }
}

/** Sizes of an area: one channel, without mipmaps, which would bleed across UV islands. */
export function areaSizes(width: number, height: number): GpuSizes {
  const compressed = 8 * blocks(width, height)
  return { uncompressed: width * height, bits8: compressed, bits4: compressed }
}

/** Sizes of a slice of up to four areas, one per channel, without mipmaps: 8 bits per texel. */
export function areaSliceSizes(width: number, height: number): GpuSizes {
  const compressed = 16 * blocks(width, height)
  return { uncompressed: 4 * width * height, bits8: compressed, bits4: compressed }
}

/** Bytes per texel of an influence map, indexed by number of layers minus 1: one float, two floats, or four half floats. */
const INFLUENCE_TEXEL = [4, 8, 8, 8]

/** Bytes of a face's influence map, which has the size of an area and one channel per layer. */
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
