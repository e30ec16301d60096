import { PNG_SIGNATURE_BYTES } from './png.ts'

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

/**
 * Why a PNG or JPEG file is not whole; undefined where it is, and for other formats. Decoders disagree about such files: some show what
 * there is, others nothing.
 */
export function imageDamage(bytes: Uint8Array): string | undefined {
  const type = imageTypeOf(bytes)
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  if (type === 'image/png') return pngDamage(bytes, view)
  return type === 'image/jpeg' ? jpegDamage(view) : undefined
}

const CUT_OFF = 'it is cut off'

/** The types of a PNG's first and last chunk. */
const IHDR = 0x49484452
const IEND = 0x49454e44

/** Chunks are a length, a type, data and a checksum of type and data (PNG, section 5.3). */
function pngDamage(bytes: Uint8Array, view: DataView): string | undefined {
  let at = PNG_SIGNATURE_BYTES
  while (at + 12 <= bytes.length) {
    const end = at + 8 + view.getUint32(at)
    if (end + 4 > bytes.length) return CUT_OFF
    if (crc32(bytes.subarray(at + 4, end)) !== view.getUint32(end)) return 'a checksum is wrong'
    const type = view.getUint32(at + 4)
    if (at === PNG_SIGNATURE_BYTES && type !== IHDR) return 'it has no header'
    if (type === IEND) return undefined
    at = end + 4
  }
  return CUT_OFF
}

let table: Uint32Array | undefined

/** PNG, annex D. */
function crc32(bytes: Uint8Array): number {
  table ??= Uint32Array.from({ length: 256 }, (_, byte) => {
    for (let bit = 0; bit < 8; bit++) byte = byte & 1 ? (byte >>> 1) ^ 0xedb88320 : byte >>> 1
    return byte
  })
  let crc = 0xffffffff
  for (let i = 0; i < bytes.length; i++) crc = (crc >>> 8) ^ table[(crc ^ bytes[i]) & 0xff]
  return ~crc >>> 0
}

// Markers of JPEG (ITU-T T.81, table B.1), after a byte 0xff.
const END_OF_IMAGE = 0xd9
const FIRST_RESTART = 0xd0
const START_OF_IMAGE = 0xd8
const FIRST_SEGMENT = 0xc0

/** Segments begin with a marker and their length; coded data follows some, in which a zero says that the byte before it is data. */
function jpegDamage(view: DataView): string | undefined {
  let at = 2
  while (at + 2 <= view.byteLength) {
    const marker = view.getUint8(at + 1)
    if (view.getUint8(at) !== 0xff || marker === 0xff) at++
    else if (marker === 0 || (marker >= FIRST_RESTART && marker <= START_OF_IMAGE)) at += 2
    else if (marker === END_OF_IMAGE) return undefined
    else if (marker < FIRST_SEGMENT) return 'it has an unknown marker'
    else if (at + 4 > view.byteLength) return CUT_OFF
    else at += 2 + view.getUint16(at + 2)
  }
  return CUT_OFF
}
