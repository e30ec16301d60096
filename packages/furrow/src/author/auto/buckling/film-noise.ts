import { exp } from '../../../math/elementary.ts'
import { blendNoise } from '../../../math/random-blend.ts'
import { clamp } from '../../../math/scalar.ts'
import { NOISE_LIMIT, planeNoise } from './plane-noise.ts'

/**
 * Random irregularities of a film: smooth random fields over the plane, see `planeNoise`. Each stream is another field.
 *
 * @param correlation standard deviation of a bump, in the unit of x and y.
 */
export type FilmNoise = (x: number, y: number, correlation: number, stream: number) => number

export function filmNoise(seed: number): FilmNoise {
  return (x, y, correlation, stream) => planeNoise(x, y, correlation, seed + stream)
}

/**
 * Blends a field with a field of another film, mirrored at x = 0. The variance stays the same.
 *
 * @param share weight of the mirrored field, 0..1.
 */
export function mirroredNoise(own: FilmNoise, other: FilmNoise, share: number): FilmNoise {
  return (x, y, correlation, stream) =>
    limited(blendNoise(own(x, y, correlation, stream), other(-x, y, correlation, stream), share))
}

/**
 * Blends a field at negative x with the same field, mirrored at x = 0. The variance stays the same.
 *
 * @param share weight of the mirrored field, 0..1.
 */
export function foldedNoise(own: FilmNoise, share: number): FilmNoise {
  return (x, y, correlation, stream) => {
    const value = own(x, y, correlation, stream)
    if (x >= 0) return value
    // Correlation of the field with itself at a distance of 2 x, if its bumps are Gaussians.
    const alike = exp(-(x * x) / (correlation * correlation))
    return limited(blendNoise(value, own(-x, y, correlation, stream), share, alike))
  }
}

function limited(value: number): number {
  return clamp(value, -NOISE_LIMIT, NOISE_LIMIT)
}
