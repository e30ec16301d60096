import { cdp } from 'vitest/browser'

/** Counts the objects that survive a garbage collection. */
export async function alive(objects: readonly WeakRef<object>[]): Promise<number> {
  // Dereferencing or creating a WeakRef keeps its target alive until the current task ends.
  await new Promise((resolve) => setTimeout(resolve))
  await cdp().send('HeapProfiler.collectGarbage')
  return new Set(objects.flatMap((object) => object.deref() ?? [])).size
}
