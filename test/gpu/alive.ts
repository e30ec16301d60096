import { cdp } from 'vitest/browser'

/** How many of some objects are left when all garbage is collected. */
export async function alive(objects: readonly WeakRef<object>[]): Promise<number> {
  // A reference that was read, or made, holds its object until the current task ends.
  await new Promise((resolve) => setTimeout(resolve))
  await cdp().send('HeapProfiler.collectGarbage')
  return new Set(objects.flatMap((object) => object.deref() ?? [])).size
}
