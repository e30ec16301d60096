/** Images of one size that become one texture array. */
export interface NamedArray {
  width: number
  height: number
  /** 1 = gray, 4 = RGBA. */
  channels: 1 | 4
  /** Whether the values are colours in sRGB; otherwise they are plain numbers, as in normal maps and areas. */
  srgb: boolean
  /** One name per layer, all different; they become the names of files again. */
  names: string[]
  /** width x height x channels bytes per layer, row 0 at the top. */
  layers: Uint8Array[]
}

/** How the layers lie in the file: `none` and `zstd` lose nothing, the others stay compressed on the GPU. */
export type Compression = 'none' | 'zstd' | 'uastc' | 'etc1s'
export const COMPRESSIONS = ['none', 'zstd', 'uastc', 'etc1s'] as const satisfies readonly Compression[]
