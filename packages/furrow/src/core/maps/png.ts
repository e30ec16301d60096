/** Header of a PNG file (PNG specification, section 11.2). */
export interface PngHeader {
  width: number
  height: number
  /** Bits per channel. */
  depth: number
  /** Colour type: 0 gray, 2 RGB, 3 palette, 4 gray and alpha, 6 RGBA. */
  colour: number
  /** Whether the image uses Adam7 interlacing. */
  isInterlaced: boolean
}

/** A complete chunk of a PNG file. */
export interface PngChunk {
  type: string
  data: Uint8Array
  isChecksumValid: boolean
}

const PNG_SIGNATURE_BYTES = 8

/** First four bytes of a PNG file. */
const SIGNATURE = 0x89504e47

/** Reads the header of a PNG file, or returns undefined for other formats. */
export function pngHeader(bytes: Uint8Array): PngHeader | undefined {
  const file = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  if (bytes.length < PNG_SIGNATURE_BYTES + 25 || file.getUint32(0) !== SIGNATURE) return undefined
  const view = new DataView(bytes.buffer, bytes.byteOffset + PNG_SIGNATURE_BYTES + 8)
  return {
    width: view.getUint32(0),
    height: view.getUint32(4),
    depth: view.getUint8(8),
    colour: view.getUint8(9),
    isInterlaced: view.getUint8(12) === 1,
  }
}

/** Reads the chunks of a PNG file up to and including `IEND`, or up to the first truncated chunk (PNG specification, section 5.3). */
export function pngChunks(bytes: Uint8Array): PngChunk[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  const chunks: PngChunk[] = []
  let at = PNG_SIGNATURE_BYTES
  while (at + 12 <= bytes.length && chunks.at(-1)?.type !== 'IEND') {
    const start = at + 8
    const end = start + view.getUint32(at)
    if (end + 4 > bytes.length) break
    chunks.push({
      type: String.fromCharCode(...bytes.subarray(at + 4, start)),
      data: bytes.subarray(start, end),
      isChecksumValid: crc32(bytes.subarray(at + 4, end)) === view.getUint32(end),
    })
    at = end + 4
  }
  return chunks
}

/** Whether chunks form a complete PNG file with valid checksums. */
export function isCompletePng(chunks: readonly PngChunk[]): boolean {
  return (
    chunks[0]?.type === 'IHDR' &&
    chunks.at(-1)!.type === 'IEND' &&
    chunks.every(({ isChecksumValid }) => isChecksumValid)
  )
}

let table: Uint32Array | undefined

/** Computes the checksum of a PNG chunk (PNG specification, annex D). */
function crc32(bytes: Uint8Array): number {
  table ??= Uint32Array.from({ length: 256 }, (_, byte) => {
    for (let bit = 0; bit < 8; bit++) byte = byte & 1 ? (byte >>> 1) ^ 0xedb88320 : byte >>> 1
    return byte
  })
  let crc = 0xffffffff
  for (let i = 0; i < bytes.length; i++) crc = (crc >>> 8) ^ table[(crc ^ bytes[i]) & 0xff]
  return ~crc >>> 0
}
