import type { NormalMap } from 'furrow/author'
import sharp from 'sharp'

/** A normal map as an RGB PNG of its own depth, 8 or 16 bits. */
export async function encodeNormalMap({ width, height, data }: NormalMap): Promise<Uint8Array> {
  return sharp(data, { raw: { width, height, channels: 3 } })
    .toColourspace(data instanceof Uint16Array ? 'rgb16' : 'srgb')
    .png({ compressionLevel: 9 })
    .toBuffer()
}
