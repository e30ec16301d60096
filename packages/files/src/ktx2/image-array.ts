/** Texture array with named layers. All layers have the same size. */
export interface NamedArray {
  width: number
  height: number
  /** 1 = gray, 4 = RGBA. */
  channels: 1 | 4
  /** True for sRGB colours. False for linear values, such as normals and weights of areas. */
  srgb: boolean
  /** Name of each layer. Names are unique and valid as file names. */
  names: string[]
  /** Bytes of each layer: `width * height * channels`, row 0 at the top. */
  layers: Uint8Array[]
}

/** Compression of a texture array. `none` and `zstd` are lossless. `uastc` and `etc1s` stay compressed on the GPU. */
export type Compression = 'none' | 'zstd' | 'uastc' | 'etc1s'
export const COMPRESSIONS = ['none', 'zstd', 'uastc', 'etc1s'] as const satisfies readonly Compression[]
