/** Time after which a tab steals the lock from another tab that does not answer, milliseconds. */
const TAKEOVER_TIMEOUT = 3000

/** Lock of a project, which only one tab can hold. The browser releases it when the tab closes or crashes. */
export interface ProjectLock {
  /** Called when another tab wants the project. That tab gets the lock when this tab releases it, or after a timeout. */
  onRequested: () => void
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

/** Resolves when no tab holds the lock of a project, or when `signal` is aborted. */
export async function whenFree(id: string, signal: AbortSignal): Promise<void> {
  // A shared lock is granted when the other tab releases the exclusive one.
  await navigator.locks.request(nameOf(id), { mode: 'shared', signal }, () => {}).catch(() => {})
}

async function request(id: string, options: LockOptions): Promise<ProjectLock | undefined> {
  // Insecure pages have no Web Locks API. Two tabs can then open the same project.
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
        // The promise `held` rejects when another tab steals the lock after `TAKEOVER_TIMEOUT`.
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
