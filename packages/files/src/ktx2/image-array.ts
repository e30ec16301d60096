/** Images of one size as the layers of one texture array. */
export interface NamedArray {
  width: number
  height: number
  /** 1 = gray, 4 = RGBA. */
  channels: 1 | 4
  /** Whether the values are sRGB colours; otherwise they are linear, as in normal maps and areas. */
  srgb: boolean
  /** A unique name per layer, valid as the name of a file. */
  names: string[]
  /** width x height x channels bytes per layer, row 0 at the top. */
  layers: Uint8Array[]
}

/** Compression of the layers: `none` and `zstd` are lossless; `uastc` and `etc1s` stay compressed on the GPU. */
export type Compression = 'none' | 'zstd' | 'uastc' | 'etc1s'
export const COMPRESSIONS = ['none', 'zstd', 'uastc', 'etc1s'] as const satisfies readonly Compression[]
