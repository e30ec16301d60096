import { imageTypeOf } from './image-type.ts'
import { jpegDamage } from './jpeg.ts'
import { isCompletePng, type PngChunk, pngChunks } from './png.ts'

/**
 * Returns why a PNG or JPEG file is damaged, or undefined for intact files and other formats. Damaged files must be rejected, because
 * some browsers decode a part of the image, and other browsers fail.
 */
export function imageDamage(bytes: Uint8Array): string | undefined {
  const type = imageTypeOf(bytes)
  if (type === 'image/png') return pngDamage(pngChunks(bytes))
  return type === 'image/jpeg' ? jpegDamage(bytes) : undefined
}

/** Returns why a PNG file with these chunks is damaged, or undefined for an intact file. */
export function pngDamage(chunks: readonly PngChunk[]): string | undefined {
  if (isCompletePng(chunks)) return undefined
  if (chunks.some(({ isChecksumValid }) => !isChecksumValid)) return 'wrong checksum'
  return chunks.at(-1)?.type === 'IEND' ? 'missing header' : 'truncated file'
}
