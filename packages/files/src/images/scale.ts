import type { Pixels } from './pixels.ts'

/** Source texels that contribute to a target texel: the index of the first, and the weights of all, which sum to 1. */
interface Taps {
  first: number
  weights: number[]
}

/**
 * Scales an image to a square with the filter of Mitchell and Netravali (Reconstruction Filters in Computer Graphics,
 * 1988, B = C = 1/3). The result is the same in Node and in all browsers.
 */
export function scaleImage({ width, height, channels, data }: Pixels, size: number): Pixels {
  const rowTaps = tapsOf(width, size)
  const stretched = new Float32Array(height * size * channels)
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < size; x++) {
      const from = (y * width + rowTaps[x].first) * channels
      addUp(rowTaps[x].weights, data, from, channels, stretched, (y * size + x) * channels, channels)
    }
  }
  const columnTaps = tapsOf(height, size)
  // The clamped array rounds values, and clamps the overshoot of the filter.
  const scaled = new Uint8ClampedArray(size * size * channels)
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const from = (columnTaps[y].first * size + x) * channels
      addUp(
        columnTaps[y].weights,
        stretched,
        from,
        size * channels,
        scaled,
        (y * size + x) * channels,
        channels,
      )
    }
  }
  return { width: size, height: size, channels, data: new Uint8Array(scaled.buffer) }
}

/** Writes one texel: the weighted sum of source texels that are `step` array elements apart. */
function addUp(
  weights: readonly number[],
  source: Uint8Array | Float32Array,
  from: number,
  step: number,
  target: Float32Array | Uint8ClampedArray,
  to: number,
  channels: number,
): void {
  for (let k = 0; k < channels; k++) {
    let sum = 0
    for (let i = 0; i < weights.length; i++) sum += weights[i] * source[from + i * step + k]
    target[to + k] = sum
  }
}

/**
 * Returns the source texels and weights of each target texel in one direction. The filter extends two
 * texels to either side, counted in source texels when enlarging and in target texels when reducing. Texels outside the
 * source are ignored: the other weights are scaled to sum to 1.
 */
function tapsOf(from: number, to: number): Taps[] {
  const scale = from / to
  const unit = Math.max(scale, 1)
  return Array.from({ length: to }, (_, i) => {
    const centre = (i + 0.5) * scale - 0.5
    const first = Math.max(0, Math.ceil(centre - 2 * unit))
    const last = Math.min(from - 1, Math.floor(centre + 2 * unit))
    const weights = Array.from({ length: last - first + 1 }, (_, k) => mitchell((first + k - centre) / unit))
    const total = weights.reduce((sum, weight) => sum + weight, 0)
    return { first, weights: weights.map((weight) => weight / total) }
  })
}

/** Mitchell-Netravali filter with B = C = 1/3 (equation 8). */
function mitchell(distance: number): number {
  const x = Math.abs(distance)
  if (x >= 2) return 0
  if (x < 1) return (7 * x * x * x - 12 * x ** 2 + 16 / 3) / 6
  return ((-7 / 3) * x * x * x + 12 * x ** 2 - 20 * x + 32 / 3) / 6
}
