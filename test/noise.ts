import sharp from 'sharp'

/** Returns a small PNG with varying texels, so that tools do not treat it as a solid colour. */
export function noise(seed: number, channels: 3 | 4 = 3, size = 16): Promise<Uint8Array> {
  const data = Uint8Array.from({ length: channels * size * size }, (_, i) => (i * 37 + seed * 101) % 251)
  return sharp(data, { raw: { width: size, height: size, channels } })
    .png()
    .toBuffer()
}
