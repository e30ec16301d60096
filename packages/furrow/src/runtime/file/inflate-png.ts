import type { PngChunk, PngHeader } from '../../core/maps/png.ts'
import type { RgbaImage } from '../../core/types.ts'

/** Number of channels of each PNG colour type that has no palette. */
const CHANNELS: Readonly<Record<number, number>> = { 0: 1, 2: 3, 4: 2, 6: 4 }

/**
 * Reads the stored pixels of a PNG file with 8 or 16 bits per channel, without palette or interlacing. 16 bits are truncated to 8.
 *
 * A 2D canvas cannot read these pixels exactly. Where alpha is small, it loses colours, because it stores premultiplied values. The colours
 * matter, because each of the four channels may store a separate gray image. Browsers also differ in how they convert 16 bits to 8. WebGL keeps
 * colours, but creating a WebGL context blocks the page for tens of milliseconds.
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

/** Undoes the PNG filter of each row. The first byte of a row is the number of its filter (PNG specification, section 9). */
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

/** Computes the Paeth predictor of the PNG specification. */
function nearest(left: number, up: number, corner: number): number {
  const [a, b, c] = [Math.abs(up - corner), Math.abs(left - corner), Math.abs(left + up - 2 * corner)]
  if (a <= b && a <= c) return left
  return b <= c ? up : corner
}
