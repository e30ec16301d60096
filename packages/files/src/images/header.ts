import type { ImageType } from './check-image.ts'

/** What the header of an image says. */
export interface Header {
  width: number
  height: number
  /** Bytes of a decoded texel. */
  texelBytes: number
}

/** Reads the header of a whole PNG or JPEG file; undefined for other formats, and where there is none. */
export function headerOf(bytes: Uint8Array, type: ImageType): Header | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  if (type === 'image/png') return pngHeader(view)
  return type === 'image/jpeg' ? jpegHeader(view) : undefined
}

/** Channels by the colour type of a PNG (PNG, 11.2.1); a palette holds colours. */
const PNG_CHANNELS: Record<number, number> = { 0: 1, 2: 3, 3: 3, 4: 2, 6: 4 }

/** The first chunk begins at byte 16: width, height, bits per channel and colour type. */
function pngHeader(view: DataView): Header {
  const channels = PNG_CHANNELS[view.getUint8(25)] ?? 4
  const bytesPerChannel = view.getUint8(24) > 8 ? 2 : 1
  return { width: view.getUint32(16), height: view.getUint32(20), texelBytes: channels * bytesPerChannel }
}

// ITU-T T.81, table B.1: markers from 0xc0 to 0xcf begin a frame, except those of tables and extensions.
const FIRST_FRAME = 0xc0
const LAST_FRAME = 0xcf
const NO_FRAMES = [0xc4, 0xc8, 0xcc]

/** Segments are a marker of two bytes, a length, and data; those of frames have the size. */
function jpegHeader(view: DataView): Header | undefined {
  for (let at = 2; at + 10 <= view.byteLength; ) {
    const marker = view.getUint8(at + 1)
    if (marker === 0xff) {
      // Bytes of 0xff fill the space before a marker.
      at++
    } else if (marker < FIRST_FRAME || marker > LAST_FRAME || NO_FRAMES.includes(marker)) {
      at += 2 + view.getUint16(at + 2)
    } else {
      return {
        width: view.getUint16(at + 7),
        height: view.getUint16(at + 5),
        texelBytes: view.getUint8(at + 9),
      }
    }
  }
  return undefined
}
