import { encode } from 'fast-png'
import type { Pixels } from './pixels.ts'

/**
 * Encodes pixels as PNG with the same channels. Gives the same bytes in Node and browsers, for packed faces. Normal maps
 * are 3% larger than with libvips.
 */
export function encodePortablePng({ width, height, channels, data }: Pixels): Uint8Array {
  return encode({ width, height, channels, data, depth: 8 }, { zlib: { level: 9 } })
}
