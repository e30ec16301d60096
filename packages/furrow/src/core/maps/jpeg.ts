// Second bytes of JPEG markers; the first byte is 0xff (ITU-T T.81, table B.1).
const END_OF_IMAGE = 0xd9
const FIRST_RESTART = 0xd0
const START_OF_IMAGE = 0xd8
const FIRST_SEGMENT = 0xc0

/**
 * Returns why a JPEG file is damaged, or undefined for an intact file.
 *
 * A JPEG file consists of segments. A segment starts with a marker and the segment's length. Entropy-coded data may follow, in which
 * the two bytes 0xff 0x00 encode one byte 0xff.
 */
export function jpegDamage(bytes: Uint8Array): string | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  let at = 2
  while (at + 2 <= view.byteLength) {
    const marker = view.getUint8(at + 1)
    if (view.getUint8(at) !== 0xff || marker === 0xff) at++
    else if (marker === 0 || (marker >= FIRST_RESTART && marker <= START_OF_IMAGE)) at += 2
    else if (marker === END_OF_IMAGE) return undefined
    else if (marker < FIRST_SEGMENT) return 'unknown JPEG marker'
    else if (at + 4 > view.byteLength) return 'truncated file'
    else at += 2 + view.getUint16(at + 2)
  }
  return 'truncated file'
}
