/** The formats of images in files, by their media types. */
export type ImageFileType = 'image/png' | 'image/jpeg' | 'image/webp' | 'image/avif' | 'image/ktx2'

/** The bytes by which they are known, as characters of Latin-1, and where these are. */
const SIGNATURES: readonly (readonly [type: ImageFileType, offset: number, bytes: string])[] = [
  ['image/png', 0, '\x89PNG\r\n\x1a\n'],
  ['image/jpeg', 0, '\xff\xd8\xff'],
  ['image/webp', 8, 'WEBP'],
  ['image/avif', 4, 'ftypavif'],
  ['image/ktx2', 0, '\xabKTX 20\xbb\r\n\x1a\n'],
]

/** The format of an encoded image, by its first bytes; undefined for any other. */
export function imageTypeOf(bytes: Uint8Array): ImageFileType | undefined {
  const head = String.fromCharCode(...bytes.subarray(0, 16))
  return SIGNATURES.find(([, offset, signature]) => head.startsWith(signature, offset))?.[0]
}
