/** The middle of some numbers; of an even count, the mean of the middle two. NaN of none. */
export function median(values: readonly number[]): number {
  return quantile(values, 0.5)
}

/** Half of all values lie within this distance: from the lower to the upper quartile. */
export function spread(values: readonly number[]): number {
  return quantile(values, 0.75) - quantile(values, 0.25)
}

/**
 * Order in which variants take their turns: each round starts one further on, so that none always follows the same
 * one or always pays for what comes first.
 */
export function turns(count: number, round: number): number[] {
  return Array.from({ length: count }, (_, i) => (i + round) % count)
}

/** Median of the ratios of each round: what slows a whole round down, such as other work, cancels out. */
export function ratio(rounds: readonly number[], base: readonly number[]): number {
  return median(rounds.map((value, i) => value / base[i]))
}

function quantile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b)
  const at = (sorted.length - 1) * share
  const low = sorted[Math.floor(at)]
  return low + (sorted[Math.ceil(at)] - low) * (at % 1)
}
