import type { PngChunk, PngHeader } from '../../core/maps/png.ts'
import type { RgbaImage } from '../../core/types.ts'

/** Number of channels by PNG colour type, without palettes. */
const CHANNELS: Readonly<Record<number, number>> = { 0: 1, 2: 3, 4: 2, 6: 4 }

/**
 * Reads the stored pixels of a PNG file: 8 or 16 bits per channel, no palette, not interlaced. 16 bits are truncated to the upper 8.
 *
 * The alpha channel may hold an area, and a 2D canvas loses colours where alpha is small, because it premultiplies. WebGL keeps them, but
 * creating a context blocks the page for tens of milliseconds. Browsers also round 16 bits differently.
 *
 * @param chunks chunks of a complete file.
 * @throws Error if the data is damaged.
 */
export async function inflatePng(
  chunks: readonly PngChunk[],
  { width, height, depth, colour }: PngHeader,
): Promise<RgbaImage> {
  const parts = chunks
    .filter(({ type }) => type === 'IDAT')
    .map(({ data }) => data as Uint8Array<ArrayBuffer>)
  const packed = new Blob(parts).stream().pipeThrough(new DecompressionStream('deflate'))
  const filtered = new Uint8Array(await new Response(packed).arrayBuffer())
  const channels = CHANNELS[colour]
  const bytes = depth / 8
  const rows = unfilter(filtered, width * channels * bytes, height, channels * bytes)
  if (channels === 4 && bytes === 1) return { width, height, data: rows }
  const data = new Uint8Array(4 * width * height).fill(255)
  for (let i = 0; i < width * height; i++) {
    const at = i * channels * bytes
    // Gray is copied to red, green and blue.
    for (let c = 0; c < 3; c++) data[4 * i + c] = rows[at + (channels > 2 ? c * bytes : 0)]
    if (channels % 2 === 0) data[4 * i + 3] = rows[at + (channels - 1) * bytes]
  }
  return { width, height, data }
}

/** Undoes the filter of each row, given by the row's first byte (PNG, section 9). */
function unfilter(filtered: Uint8Array, stride: number, height: number, step: number): Uint8Array {
  if (filtered.length < (stride + 1) * height) throw new Error('too few pixels')
  const rows = new Uint8Array(stride * height)
  for (let y = 0; y < height; y++) {
    const filter = filtered[y * (stride + 1)]
    const from = y * (stride + 1) + 1
    const to = y * stride
    for (let x = 0; x < stride; x++) {
      const left = x < step ? 0 : rows[to + x - step]
      const up = y === 0 ? 0 : rows[to + x - stride]
      const corner = x < step || y === 0 ? 0 : rows[to + x - stride - step]
      rows[to + x] = filtered[from + x] + predict(filter, left, up, corner)
    }
  }
  return rows
}

function predict(filter: number, left: number, up: number, corner: number): number {
  if (filter === 1) return left
  if (filter === 2) return up
  if (filter === 3) return (left + up) >> 1
  return filter === 4 ? nearest(left, up, corner) : 0
}

/** Paeth predictor. */
function nearest(left: number, up: number, corner: number): number {
  const [a, b, c] = [Math.abs(up - corner), Math.abs(left - corner), Math.abs(left + up - 2 * corner)]
  if (a <= b && a <= c) return left
  return b <= c ? up : corner
}
