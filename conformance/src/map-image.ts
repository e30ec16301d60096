import { seeded } from '../../test/random.ts'

/** Image of a sample file: 3 channels of 8 bits. */
export interface MapImage {
  width: number
  height: number
  data: Uint8Array
}

/** Default side of images in texels: half the side of the pictures, so that engines must interpolate. */
export const SIDE = 16

/** Returns random independent texels, the hardest case for interpolation. */
export function noise(seed: number, side = SIDE): MapImage {
  return { width: side, height: side, data: Uint8Array.from({ length: 3 * side * side }, seededBytes(seed)) }
}

/** Returns random unit normals within 45 degrees of the surface normal. */
export function normals(seed: number, side = SIDE): MapImage {
  const random = seeded(seed)
  const data = Array.from({ length: side * side }, () => {
    const [x, y] = [random() - 0.5, random() - 0.5]
    return [x, y, Math.sqrt(1 - x * x - y * y)].map((value) => Math.round((value * 0.5 + 0.5) * 255))
  })
  return { width: side, height: side, data: Uint8Array.from(data.flat()) }
}

/** Returns an image of one colour. */
export function uniform(red: number, green: number, blue: number, side = SIDE): MapImage {
  return image(side, () => [red, green, blue])
}

/** Returns a flat normal map. */
export const flat = (): MapImage => uniform(128, 128, 255)

/** @param texel returns the three bytes at a column and row. */
export function image(side: number, texel: (column: number, row: number) => readonly number[]): MapImage {
  const data = Array.from({ length: side * side }, (_, i) => texel(i % side, Math.floor(i / side)))
  return { width: side, height: side, data: Uint8Array.from(data.flat()) }
}

function seededBytes(seed: number): () => number {
  const random = seeded(seed)
  return () => Math.floor(random() * 256)
}
