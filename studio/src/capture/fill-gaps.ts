/**
 * Replaces each NaN: between two numbers linearly by index, before the first and after the last in steps from these.
 *
 * @returns a new array; where there is no number at all, steps from 0.
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
