import type { ImageType } from './check-image.ts'

export interface Header {
  width: number
  height: number
  /** Size of a decoded texel, bytes. */
  texelBytes: number
}

/** Reads the header of a PNG or JPEG. Returns undefined for other formats, and for a JPEG without a frame. */
export function headerOf(bytes: Uint8Array, type: ImageType): Header | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  if (type === 'image/png') return pngHeader(view)
  return type === 'image/jpeg' ? jpegHeader(view) : undefined
}

/** Number of channels per PNG colour type (PNG, 11.2.1). Palettes decode to three channels. */
const PNG_CHANNELS: Record<number, number> = { 0: 1, 2: 3, 3: 3, 4: 2, 6: 4 }

/** Reads the IHDR chunk: width at byte 16, height at 20, bits per channel at 24, colour type at 25. */
function pngHeader(view: DataView): Header {
  const channels = PNG_CHANNELS[view.getUint8(25)] ?? 4
  const bytesPerChannel = view.getUint8(24) > 8 ? 2 : 1
  return { width: view.getUint32(16), height: view.getUint32(20), texelBytes: channels * bytesPerChannel }
}

// Markers of frames (ITU-T T.81, table B.1). Three markers in this range do not start frames.
const FIRST_FRAME = 0xc0
const LAST_FRAME = 0xcf
const NO_FRAMES = [0xc4, 0xc8, 0xcc]

/** Reads the size from the first frame. A segment is a two-byte marker, a two-byte length, and data. */
function jpegHeader(view: DataView): Header | undefined {
  for (let at = 2; at + 10 <= view.byteLength; ) {
    const marker = view.getUint8(at + 1)
    if (marker === 0xff) {
      // Skips a fill byte before a marker.
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
