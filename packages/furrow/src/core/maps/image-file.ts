import { imageTypeOf } from './image-type.ts'
import { jpegDamage } from './jpeg.ts'
import { isWholePng, type PngChunk, pngChunks } from './png.ts'

/**
 * Why a PNG or JPEG file is not whole; undefined where it is, and for other formats. Decoders disagree about such files: some show what
 * there is, others nothing.
 */
export function imageDamage(bytes: Uint8Array): string | undefined {
  const type = imageTypeOf(bytes)
  if (type === 'image/png') return pngDamage(pngChunks(bytes))
  return type === 'image/jpeg' ? jpegDamage(bytes) : undefined
}

/** The same for the chunks of a PNG file. */
export function pngDamage(chunks: readonly PngChunk[]): string | undefined {
  if (isWholePng(chunks)) return undefined
  if (chunks.some(({ isSound }) => !isSound)) return 'a checksum is wrong'
  return chunks.at(-1)?.type === 'IEND' ? 'it has no header' : 'it is cut off'
}
