/**
 * Replaces each NaN. Gaps between two numbers are interpolated; gaps at either end continue from the nearest number by `step`.
 *
 * @returns new array. If all values are NaN, it counts from 0 by `step`.
 */
export function fillGaps(values: readonly number[], step: number): number[] {
  const filled = [...values]
  const known = values.flatMap((value, i) => (Number.isNaN(value) ? [] : [i]))
  let next = 0
  for (const i of values.keys()) {
    while (next < known.length && known[next] < i) next++
    const [before, after] = [known[next - 1], known[next]]
    if (after === i) continue
    if (before === undefined && after === undefined) filled[i] = step * i
    else if (before === undefined) filled[i] = values[after] - step * (after - i)
    else if (after === undefined) filled[i] = values[before] + step * (i - before)
    else filled[i] = values[before] + ((values[after] - values[before]) * (i - before)) / (after - before)
  }
  return filled
}
