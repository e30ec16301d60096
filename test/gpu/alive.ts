import { cdp } from 'vitest/browser'

/** Runs a garbage collection and counts the objects that survive. */
export async function alive(objects: readonly WeakRef<object>[]): Promise<number> {
  // A WeakRef keeps its target alive until the end of the task that created or dereferenced it, so wait for the next task.
  await new Promise((resolve) => setTimeout(resolve))
  await cdp().send('HeapProfiler.collectGarbage')
  return new Set(objects.flatMap((object) => object.deref() ?? [])).size
}
