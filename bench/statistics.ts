/** Returns the median, or NaN without values. */
export function median(values: readonly number[]): number {
  return quantile(values, 0.5)
}

/** Returns the interquartile range. */
export function spread(values: readonly number[]): number {
  return quantile(values, 0.75) - quantile(values, 0.25)
}

/** Returns the order of the variants in a round. Rounds start with different variants, because the first is slower. */
export function roundOrder(count: number, round: number): number[] {
  return Array.from({ length: count }, (_, i) => (i + round) % count)
}

/** Returns the ratio of the fastest rounds. Other processes and bad shader compilations only slow rounds down. */
export function ratio(rounds: readonly number[], base: readonly number[]): number {
  return Math.min(...rounds) / Math.min(...base)
}

function quantile(values: readonly number[], fraction: number): number {
  const sorted = [...values].sort((a, b) => a - b)
  const index = (sorted.length - 1) * fraction
  const low = sorted[Math.floor(index)]
  return low + (sorted[Math.ceil(index)] - low) * (index % 1)
}
