import type { Bounds } from 'furrow/internal'

interface Pixels {
  width: number
  data: Uint8Array
}

export function copyRect(
  { width, data }: Pixels,
  { x0, y0, x1, y1 }: Bounds,
  channels: number,
): Uint8Array<ArrayBuffer> {
  const row = channels * (x1 - x0)
  const out = new Uint8Array(row * (y1 - y0))
  for (let y = y0; y < y1; y++) {
    const start = channels * (y * width + x0)
    out.set(data.subarray(start, start + row), row * (y - y0))
  }
  return out
}

export function pasteRect(
  { width, data }: Pixels,
  { x0, y0, x1, y1 }: Bounds,
  channels: number,
  texels: Uint8Array,
): void {
  const row = channels * (x1 - x0)
  for (let y = y0; y < y1; y++) {
    data.set(texels.subarray(row * (y - y0), row * (y - y0 + 1)), channels * (y * width + x0))
  }
}
