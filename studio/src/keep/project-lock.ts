export type ReleaseLock = () => Promise<void>

/**
 * Takes the lock of a project, which one tab at a time has. It is released when the tab closes, crashes or calls what this returns.
 *
 * @returns a function that releases the lock, and resolves when another tab can take it; undefined where another tab has it.
 */
export async function lockProject(id: string): Promise<ReleaseLock | undefined> {
  // Pages that are not served securely have no locks.
  if (globalThis.navigator?.locks === undefined) return async () => {}
  return new Promise((resolve, reject) => {
    const hold = (lock: Lock | null) => {
      if (!lock) return resolve(undefined)
      return new Promise<void>((end) => {
        resolve(() => {
          end()
          return released
        })
      })
    }
    const released = navigator.locks.request(`furrow-project ${id}`, { ifAvailable: true }, hold)
    released.catch(reject)
  })
}
