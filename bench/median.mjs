/** Returns the median. For an even number of values, returns the larger of the two middle values. */
export function median(numbers) {
  return [...numbers].sort((a, b) => a - b)[Math.floor(numbers.length / 2)]
}
