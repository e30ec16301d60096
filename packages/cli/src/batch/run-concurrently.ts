/** Runs `work` for every item in order, at most `concurrency` at a time. Throws the first error after the running work ends. */
export async function runConcurrently<T>(
  items: readonly T[],
  concurrency: number,
  work: (item: T, index: number) => Promise<void>,
): Promise<void> {
  let next = 0
  const errors: unknown[] = []
  const lane = async () => {
    while (next < items.length && errors.length === 0) {
      const index = next++
      await work(items[index], index).catch((error) => errors.push(error))
    }
  }
  await Promise.all(Array.from({ length: concurrency }, lane))
  if (errors.length > 0) throw errors[0]
}
