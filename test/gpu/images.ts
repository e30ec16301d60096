/** Writes PNG files that a canvas cannot write: 16 bits per channel, and huge sizes. */

import { crc32 } from '../crc32.ts'

/**
 * Writes a PNG file.
 *
 * @param raw filtered rows, without the byte that names the filter.
 * @param filter filter type of all rows, 0 to 4.
 */
export async function png(
  width: number,
  height: number,
  depth: 8 | 16,
  colour: 0 | 2 | 4 | 6,
  raw: Uint8Array,
  filter = 0,
) {
  const stride = (raw.length / height) | 0
  const filtered = new Uint8Array((stride + 1) * height)
  for (let y = 0; y < height; y++) {
    filtered[y * (stride + 1)] = filter
    filtered.set(raw.subarray(y * stride, (y + 1) * stride), y * (stride + 1) + 1)
  }
  const header = new Uint8Array(13)
  const view = new DataView(header.buffer)
  view.setUint32(0, width)
  view.setUint32(4, height)
  header.set([depth, colour, 0, 0, 0], 8)
  const data = new Uint8Array(
    await new Response(
      new Blob([filtered]).stream().pipeThrough(new CompressionStream('deflate')),
    ).arrayBuffer(),
  )
  const signature = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a)
  return new Blob([signature, chunk('IHDR', header), chunk('IDAT', data), chunk('IEND', new Uint8Array())], {
    type: 'image/png',
  })
}

/** Returns an 8-bit gray PNG of one value. */
export const grayPng = (width: number, height: number, value: number) =>
  png(width, height, 8, 0, new Uint8Array(width * height).fill(value))

function chunk(type: string, data: Uint8Array): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(12 + data.length)
  const view = new DataView(bytes.buffer)
  view.setUint32(0, data.length)
  for (let i = 0; i < 4; i++) bytes[4 + i] = type.charCodeAt(i)
  bytes.set(data, 8)
  view.setUint32(8 + data.length, crc32(bytes.subarray(4, 8 + data.length)))
  return bytes
}
