import type { Bounds } from '../bounds.ts'
import { FurrowError } from '../error.ts'
import type { RgbaImage } from '../types.ts'
import { toByte } from './normal-byte.ts'

/**
 * Lays one tangent-space normal map over another by reoriented normal mapping (C. Barre-Brisebois, S. Hill, "Blending in Detail", 2012).
 * Where one map is flat, the bytes of the other map are copied unchanged.
 *
 * @param base linear, +Y towards smaller v; not modified.
 * @param detail normal map in the same convention and size.
 * @returns a new image with alpha 255.
 * @throws FurrowError if the sizes differ.
 */
export function combineNormals(base: RgbaImage, detail: RgbaImage): RgbaImage {
  checkSizes(base, detail)
  const { width, height } = detail
  const combined = { width, height, data: detail.data.slice() }
  overlayNormals(base, combined, { x0: 0, y0: 0, x1: width, y1: height })
  return combined
}

/** @throws FurrowError if the sizes differ. */
export function checkSizes(base: RgbaImage, detail: RgbaImage): void {
  const { width, height } = base
  if (detail.width === width && detail.height === height) return
  throw new FurrowError({
    who: 'combineNormals',
    problem: 'size of the detail map differs from the base map',
    value: `${detail.width} x ${detail.height}`,
    limit: `${width} x ${height}`,
    remedy: 'render the detail map at the size of the base map, or scale the base map',
  })
}

/** Combines the maps as `combineNormals` does, but only in a rectangle, and overwrites `detail` with the result. */
export function overlayNormals(
  base: RgbaImage,
  detail: RgbaImage,
  { x0, y0, x1, y1 }: Readonly<Bounds>,
): void {
  const { width, data } = detail
  for (let y = y0; y < y1; y++) {
    for (let i = 4 * (y * width + x0); i < 4 * (y * width + x1); i += 4) {
      if (isFlat(data, i)) copy(base.data, i, data)
      else if (!isFlat(base.data, i)) blend(base.data, data, i, data)
      data[i + 3] = 255
    }
  }
}

function isFlat(data: Uint8Array, i: number): boolean {
  return data[i] === 128 && data[i + 1] === 128 && data[i + 2] === 255
}

function copy(from: Uint8Array, i: number, to: Uint8Array): void {
  to[i] = from[i]
  to[i + 1] = from[i + 1]
  to[i + 2] = from[i + 2]
}

function blend(base: Uint8Array, detail: Uint8Array, i: number, out: Uint8Array): void {
  const tx = base[i] / 127.5 - 1
  const ty = base[i + 1] / 127.5 - 1
  const tz = base[i + 2] / 127.5
  // Byte 128 encodes 0 but decodes to half a byte step above 0. The decoded base contains this half step, so the detail is decoded
  // without it. Otherwise the half step would count twice.
  const ux = -(detail[i] - 128) / 127.5
  const uy = -(detail[i + 1] - 128) / 127.5
  const uz = detail[i + 2] / 127.5 - 1
  const scale = (tx * ux + ty * uy + tz * uz) / Math.max(tz, 1e-6)
  const [x, y, z] = [tx * scale - ux, ty * scale - uy, tz * scale - uz]
  const length = Math.sqrt(x * x + y * y + z * z)
  out[i] = toByte(length === 0 ? 0 : x / length)
  out[i + 1] = toByte(length === 0 ? 0 : y / length)
  out[i + 2] = toByte(length === 0 ? 1 : z / length)
}
