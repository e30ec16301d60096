import type { GrayImage } from '../../../core/types.ts'

/** Halves the width and height of a map. Both must be even. Each texel becomes the rounded mean of four texels. @internal */
export function halfSide({
  width,
  height,
  data,
}: Pick<GrayImage, 'width' | 'height'> & { data: ArrayLike<number> }): GrayImage {
  const half = { width: width / 2, height: height / 2 }
  const out = new Uint8Array(half.width * half.height)
  for (let y = 0; y < half.height; y++) {
    for (let x = 0; x < half.width; x++) {
      const i = 2 * y * width + 2 * x
      out[y * half.width + x] = Math.round(
        (data[i] + data[i + 1] + data[i + width] + data[i + width + 1]) / 4,
      )
    }
  }
  return { ...half, data: out }
}

/**
 * Converts heights in millimetres to gray levels 0..255, where 127.5 is 0 mm. `amplitude` is the difference in height between levels 255 and
 * 0, in metres.
 *
 * @internal
 */
export function heightLevels(millimetres: Float32Array): { levels: Float32Array; amplitude: number } {
  let largest = 0.001
  for (let i = 0; i < millimetres.length; i++) largest = Math.max(largest, Math.abs(millimetres[i]))
  const levels = new Float32Array(millimetres.length)
  for (let i = 0; i < levels.length; i++) levels[i] = 127.5 + (127.5 * millimetres[i]) / largest
  return { levels, amplitude: (2 * largest) / 1000 }
}
