/** Milliseconds that a tab has to save before another one takes its project: one that hangs never answers. */
const PATIENCE = 3000

/** The lock of a project, which one tab at a time has. It is released when the tab closes or crashes too. */
export interface ProjectLock {
  /** Called when another tab wants the project. It takes the lock when it is released, or after a few seconds. */
  onWanted: () => void
  /** Whether this tab still has the lock. */
  readonly isHeld: boolean
  /** Resolves when another tab can take it. */
  release(): Promise<void>
}

/** Takes the lock of a project; undefined where another tab has it. */
export function lockProject(id: string): Promise<ProjectLock | undefined> {
  return request(id, { ifAvailable: true })
}

/** Takes the lock of a project from the tab that has it. */
export async function takeLock(id: string): Promise<ProjectLock> {
  const channel = new BroadcastChannel(nameOf(id))
  channel.postMessage('wanted')
  channel.close()
  try {
    return (await request(id, { signal: AbortSignal.timeout(PATIENCE) }))!
  } catch {
    return (await request(id, { steal: true }))!
  }
}

async function request(id: string, options: LockOptions): Promise<ProjectLock | undefined> {
  // Pages that are not served securely have no locks.
  if (globalThis.navigator?.locks === undefined) {
    return { onWanted() {}, isHeld: true, release: async () => {} }
  }
  return new Promise((resolve, reject) => {
    const hold = (granted: Lock | null) => {
      if (!granted) return resolve(undefined)
      const channel = new BroadcastChannel(nameOf(id))
      return new Promise<void>((end) => {
        const lock: ProjectLock & { isHeld: boolean } = {
          onWanted() {},
          isHeld: true,
          async release() {
            lock.isHeld = false
            channel.close()
            end()
            await released
          },
        }
        channel.onmessage = () => lock.onWanted()
        // A tab that does not wait any longer takes it without asking.
        const released: Promise<unknown> = held.catch(() => {
          if (!lock.isHeld) return
          lock.isHeld = false
          channel.close()
          lock.onWanted()
        })
        resolve(lock)
      })
    }
    const held: Promise<unknown> = navigator.locks.request(nameOf(id), options, hold)
    held.catch(reject)
  })
}

function nameOf(id: string): string {
  return `furrow-project ${id}`
}
