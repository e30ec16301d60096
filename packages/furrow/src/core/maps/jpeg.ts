// Markers of JPEG (ITU-T T.81, table B.1), after a byte 0xff.
const END_OF_IMAGE = 0xd9
const FIRST_RESTART = 0xd0
const START_OF_IMAGE = 0xd8
const FIRST_SEGMENT = 0xc0

/**
 * Why a JPEG file is not whole; undefined where it is.
 *
 * Segments begin with a marker and their length; coded data follows some, in which a zero says that the byte before it is data.
 */
export function jpegDamage(bytes: Uint8Array): string | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  let at = 2
  while (at + 2 <= view.byteLength) {
    const marker = view.getUint8(at + 1)
    if (view.getUint8(at) !== 0xff || marker === 0xff) at++
    else if (marker === 0 || (marker >= FIRST_RESTART && marker <= START_OF_IMAGE)) at += 2
    else if (marker === END_OF_IMAGE) return undefined
    else if (marker < FIRST_SEGMENT) return 'it has an unknown marker'
    else if (at + 4 > view.byteLength) return 'it is cut off'
    else at += 2 + view.getUint16(at + 2)
  }
  return 'it is cut off'
}
