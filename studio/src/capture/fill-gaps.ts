/**
 * Replaces each NaN in a list. Between two numbers, interpolates linearly. Before the first number and after the last one, the new values
 * increase by `step` per element.
 *
 * @returns new array. If all values are NaN, it contains 0, `step`, `2 * step` and so on.
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
