/** Median; NaN if there are no values. */
export function median(values: readonly number[]): number {
  return quantile(values, 0.5)
}

/** Interquartile range. */
export function spread(values: readonly number[]): number {
  return quantile(values, 0.75) - quantile(values, 0.25)
}

/**
 * Order of the variants in a round: each round starts one further on, so that no variant always comes first and pays for it.
 */
export function roundOrder(count: number, round: number): number[] {
  return Array.from({ length: count }, (_, i) => (i + round) % count)
}

/**
 * Quotient of the quickest rounds. What differs from round to round, other processes and what a compiler happens to make of the same
 * shader, only ever slows down, the latter by a tenth to four.
 */
export function ratio(rounds: readonly number[], base: readonly number[]): number {
  return Math.min(...rounds) / Math.min(...base)
}

function quantile(values: readonly number[], fraction: number): number {
  const sorted = [...values].sort((a, b) => a - b)
  const index = (sorted.length - 1) * fraction
  const low = sorted[Math.floor(index)]
  return low + (sorted[Math.ceil(index)] - low) * (index % 1)
}
