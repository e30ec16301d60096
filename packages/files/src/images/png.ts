import { encode } from 'fast-png'
import type { Pixels } from './pixels.ts'

/**
 * Encodes pixels as PNG. Keeps all channels. The bytes are equal in Node and in all browsers. The PNG of a normal map
 * is 3% larger than a PNG from libvips.
 */
export function encodePortablePng({ width, height, channels, data }: Pixels): Uint8Array {
  return encode({ width, height, channels, data, depth: 8 }, { zlib: { level: 9 } })
}
