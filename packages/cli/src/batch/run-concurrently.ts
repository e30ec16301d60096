/**
 * Runs `work` for every item in order, at most `concurrency` at a time. After an error it starts no further work, waits
 * for running work, and throws the first error.
 */
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
