import { length2 } from './vector.ts'

/**
 * Blends two independent random numbers that are uniform in 0..1. The result is uniform too: the cumulative distribution function of the
 * weighted sum, a trapezoidal distribution, converts it.
 *
 * @param share weight of the second number, 0..1.
 */
export function blendUniform(first: number, second: number, share: number): number {
  const sum = (1 - share) * first + share * second
  const [low, high] = [Math.min(share, 1 - share), Math.max(share, 1 - share)]
  if (sum < low) return (sum * sum) / (2 * low * high)
  if (sum > high) return 1 - ((1 - sum) * (1 - sum)) / (2 * low * high)
  return (sum - low / 2) / high
}

/**
 * Blends two random numbers with mean 0 and the same variance. The result has this variance too.
 *
 * @param share weight of the second number, 0..1.
 * @param correlation correlation of the two numbers, 0..1.
 */
export function blendNoise(first: number, second: number, share: number, correlation = 0): number {
  const sum = (1 - share) * first + share * second
  // Weights that add up to 1 change the variance by this factor's square.
  const spread = length2(1 - share, share)
  return sum / Math.sqrt(spread * spread + 2 * correlation * share * (1 - share))
}
