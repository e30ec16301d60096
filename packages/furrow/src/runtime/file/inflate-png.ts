import type { PngChunk, PngHeader } from '../../core/maps/png.ts'
import type { RgbaImage } from '../../core/types.ts'

/**
 * Reads the pixels of a PNG file with alpha, 8 bits per channel and not interlaced, exactly as stored: such a file holds four areas. A 2D
 * canvas multiplies colours by alpha, and so loses them where alpha is small. WebGL keeps them, but creating a context blocks the page for
 * tens of milliseconds.
 *
 * @param chunks of a whole file.
 * @throws Error when its data is damaged.
 */
export async function inflatePng(
  chunks: readonly PngChunk[],
  { width, height, colour }: PngHeader,
): Promise<RgbaImage> {
  const parts = chunks
    .filter(({ type }) => type === 'IDAT')
    .map(({ data }) => data as Uint8Array<ArrayBuffer>)
  const packed = new Blob(parts).stream().pipeThrough(new DecompressionStream('deflate'))
  const filtered = new Uint8Array(await new Response(packed).arrayBuffer())
  const channels = colour === 4 ? 2 : 4
  const rows = unfilter(filtered, width * channels, height, channels)
  if (channels === 4) return { width, height, data: rows }
  const data = new Uint8Array(4 * width * height)
  for (let i = 0; i < width * height; i++) {
    data.fill(rows[2 * i], 4 * i, 4 * i + 3)
    data[4 * i + 3] = rows[2 * i + 1]
  }
  return { width, height, data }
}

/** Undoes the filter of each row, which its first byte names (PNG, section 9). */
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

/** Paeth's predictor. */
function nearest(left: number, up: number, corner: number): number {
  const [a, b, c] = [Math.abs(up - corner), Math.abs(left - corner), Math.abs(left + up - 2 * corner)]
  if (a <= b && a <= c) return left
  return b <= c ? up : corner
}
