/** Media types of image files. */
export type ImageFileType = 'image/png' | 'image/jpeg' | 'image/webp' | 'image/avif' | 'image/ktx2'

/** Signatures of image files: each has a byte offset, and the bytes as Latin-1 characters. */
const SIGNATURES: readonly (readonly [type: ImageFileType, offset: number, bytes: string])[] = [
  ['image/png', 0, '\x89PNG\r\n\x1a\n'],
  ['image/jpeg', 0, '\xff\xd8\xff'],
  ['image/webp', 8, 'WEBP'],
  ['image/avif', 4, 'ftypavif'],
  ['image/ktx2', 0, '\xabKTX 20\xbb\r\n\x1a\n'],
]

/** Detects the format of an image file by its first bytes. Returns undefined if no signature matches. */
export function imageTypeOf(bytes: Uint8Array): ImageFileType | undefined {
  const head = String.fromCharCode(...bytes.subarray(0, 16))
  return SIGNATURES.find(([, offset, signature]) => head.startsWith(signature, offset))?.[0]
}
