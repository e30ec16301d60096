import { seeded } from '../../test/random.ts'

/** Image of a sample file, with 3 channels of 8 bits. Row 0 is at the top. */
export interface MapImage {
  width: number
  height: number
  data: Uint8Array
}

/**
 * Default width and height of images, texels. The expected pictures are twice as large, so engines must interpolate.
 */
export const SIDE = 16

/** Returns an image of independent random texels, in which errors of interpolation show most. */
export function noise(seed: number, side = SIDE): MapImage {
  return { width: side, height: side, data: Uint8Array.from({ length: 3 * side * side }, seededBytes(seed)) }
}

/** Returns a normal map of random unit normals, at most 45 degrees from the surface normal. */
export function normals(seed: number, side = SIDE): MapImage {
  const random = seeded(seed)
  const data = Array.from({ length: side * side }, () => {
    const [x, y] = [random() - 0.5, random() - 0.5]
    return [x, y, Math.sqrt(1 - x * x - y * y)].map((value) => Math.round((value * 0.5 + 0.5) * 255))
  })
  return { width: side, height: side, data: Uint8Array.from(data.flat()) }
}

export function uniform(red: number, green: number, blue: number, side = SIDE): MapImage {
  return image(side, () => [red, green, blue])
}

export const flat = (): MapImage => uniform(128, 128, 255)

/**
 * Returns an image with `side` x `side` texels.
 *
 * @param texel returns the three bytes of a texel.
 */
export function image(side: number, texel: (column: number, row: number) => readonly number[]): MapImage {
  const data = Array.from({ length: side * side }, (_, i) => texel(i % side, Math.floor(i / side)))
  return { width: side, height: side, data: Uint8Array.from(data.flat()) }
}

function seededBytes(seed: number): () => number {
  const random = seeded(seed)
  return () => Math.floor(random() * 256)
}
