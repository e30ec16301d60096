/** Milliseconds before a project is taken from a tab that does not answer. */
const TAKEOVER_TIMEOUT = 3000

/** Exclusive lock of a project. Closing or crashing the tab releases the lock. */
export interface ProjectLock {
  /** Called when another tab requests the project. That tab takes the lock on release, or after a timeout. */
  onRequested: () => void
  /** Whether this tab holds the lock. */
  readonly isHeld: boolean
  /** Releases the lock. Resolves when another tab can take it. */
  release(): Promise<void>
}

/** Locks a project. Returns undefined if another tab holds the lock. */
export function lockProject(id: string): Promise<ProjectLock | undefined> {
  return request(id, { ifAvailable: true })
}

/** Takes a project's lock over from another tab. */
export async function takeLock(id: string): Promise<ProjectLock> {
  const channel = new BroadcastChannel(nameOf(id))
  channel.postMessage('wanted')
  channel.close()
  try {
    return (await request(id, { signal: AbortSignal.timeout(TAKEOVER_TIMEOUT) }))!
  } catch {
    return (await request(id, { steal: true }))!
  }
}

async function request(id: string, options: LockOptions): Promise<ProjectLock | undefined> {
  // The Web Locks API needs a secure context.
  if (globalThis.navigator?.locks === undefined) {
    return { onRequested() {}, isHeld: true, release: async () => {} }
  }
  return new Promise((resolve, reject) => {
    const hold = (granted: Lock | null) => {
      if (!granted) return resolve(undefined)
      const channel = new BroadcastChannel(nameOf(id))
      return new Promise<void>((end) => {
        const lock: ProjectLock & { isHeld: boolean } = {
          onRequested() {},
          isHeld: true,
          async release() {
            lock.isHeld = false
            channel.close()
            end()
            await released
          },
        }
        channel.onmessage = () => lock.onRequested()
        // After its timeout, another tab steals the lock.
        const released: Promise<unknown> = held.catch(() => {
          if (!lock.isHeld) return
          lock.isHeld = false
          channel.close()
          lock.onRequested()
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
