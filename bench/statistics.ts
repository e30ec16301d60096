/** Returns the mean, or NaN without values. */
export function mean(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length
}

/** Returns the median, or NaN without values. */
export function median(values: readonly number[]): number {
  return quantile(values, 0.5)
}

/** Returns the interquartile range, or NaN without values. */
export function spread(values: readonly number[]): number {
  return quantile(values, 0.75) - quantile(values, 0.25)
}

/** Returns the order in which a round measures the variants. Each round starts with a different one, because the first measurement is slower. */
export function roundOrder(count: number, round: number): number[] {
  return Array.from({ length: count }, (_, i) => (i + round) % count)
}

/** Returns the fastest round divided by the fastest round of `base`. Minima are used, because disturbances only slow rounds down. */
export function ratio(rounds: readonly number[], base: readonly number[]): number {
  return Math.min(...rounds) / Math.min(...base)
}

function quantile(values: readonly number[], fraction: number): number {
  const sorted = [...values].sort((a, b) => a - b)
  const index = (sorted.length - 1) * fraction
  const low = sorted[Math.floor(index)]
  return low + (sorted[Math.ceil(index)] - low) * (index % 1)
}
