/** Texture array: named images of the same size, one per layer. */
export interface NamedArray {
  width: number
  height: number
  /** 1 = gray, 4 = RGBA. */
  channels: 1 | 4
  /** True for sRGB colours; false for linear values, as in normal maps and areas. */
  srgb: boolean
  /** One unique name per layer, valid as a file name. */
  names: string[]
  /** width x height x channels bytes per layer, row 0 at the top. */
  layers: Uint8Array[]
}

/** Compression of the layers: `none` and `zstd` are lossless; `uastc` and `etc1s` stay compressed on the GPU. */
export type Compression = 'none' | 'zstd' | 'uastc' | 'etc1s'
export const COMPRESSIONS = ['none', 'zstd', 'uastc', 'etc1s'] as const satisfies readonly Compression[]
