/** The parts of a PNG file (PNG, sections 5.3 and 11.2). */
export interface PngHeader {
  width: number
  height: number
  /** Bits per channel. */
  depth: number
  /** 0 gray, 2 RGB, 3 a palette, 4 gray and alpha, 6 RGBA. */
  colour: number
  /** Whether its rows are stored in seven passes. */
  isInterlaced: boolean
}

/** Bytes before the first chunk. */
export const PNG_SIGNATURE_BYTES = 8

/** The first bytes of the signature. */
const SIGNATURE = 0x89504e47

/** The header of a PNG file; undefined for any other. */
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

/** The data of all chunks of a type, in order, of a PNG file that is whole. */
export function pngChunks(bytes: Uint8Array<ArrayBuffer>, type: string): Uint8Array<ArrayBuffer>[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset)
  const found: Uint8Array<ArrayBuffer>[] = []
  let at = PNG_SIGNATURE_BYTES
  while (at + 12 <= bytes.length) {
    const start = at + 8
    const end = start + view.getUint32(at)
    if (String.fromCharCode(...bytes.subarray(at + 4, start)) === type) found.push(bytes.subarray(start, end))
    at = end + 4
  }
  return found
}
