/**
 * Browsers end workers without any event, as when memory runs out, but they release the locks that these held: a worker holds one while it
 * lives, and the page waits for it.
 */

/** What a worker tells the page first: the name of its lock. */
interface Alive {
  lock: string
}

/** In a worker: lets the page notice its end. Pages that are not served securely have no locks, and notice errors only. */
export function holdLife(): void {
  if (globalThis.navigator?.locks === undefined) return
  const lock = crypto.randomUUID()
  const hold = () => {
    postMessage({ lock } satisfies Alive)
    return new Promise(() => {})
  }
  navigator.locks.request(lock, hold).catch(() => {})
}

/**
 * On the page: rejects when a worker cannot be loaded, or ends by itself. It is to be called in the task that made the worker.
 *
 * @param error makes the error, of what the browser says about the end.
 * @param signal ends the wait: the promise rejects with its reason.
 */
export function endOf(
  worker: Worker,
  error: (reason: string | undefined) => Error,
  signal: AbortSignal,
): Promise<never> {
  const end = new Promise<never>((_, reject) => {
    signal.addEventListener('abort', () => reject(signal.reason), { once: true })
    worker.addEventListener(
      'error',
      (event) => {
        // The promise tells it; the console need not.
        event.preventDefault()
        reject(error(event.message))
      },
      { signal },
    )
    worker.addEventListener(
      'message',
      ({ data }: MessageEvent<Partial<Alive>>) => {
        if (data?.lock === undefined) return
        // Rejects when the signal ends the wait.
        navigator.locks.request(data.lock, { signal }, () => reject(error(undefined))).catch(() => {})
      },
      { signal },
    )
  })
  // Who waits for something else as well hears of it there.
  end.catch(() => {})
  return end
}
