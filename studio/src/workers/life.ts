/**
 * Detects dead workers. A browser can end a worker without an event, for example when memory runs out. But it always releases the worker's
 * locks. So each worker holds a lock, and the page waits for this lock. If the page gets the lock, the worker is dead.
 */

/** First message of a worker: the name of its lock. */
interface Alive {
  lock: string
}

/** Called by a worker: holds a lock until the worker dies. On insecure pages, which have no locks, only errors are detected. */
export function holdLifeLock(): void {
  if (globalThis.navigator?.locks === undefined) return
  const lock = crypto.randomUUID()
  const hold = () => {
    postMessage({ lock } satisfies Alive)
    return new Promise(() => {})
  }
  navigator.locks.request(lock, hold).catch(() => {})
}

/**
 * Returns a promise that rejects if a worker cannot be loaded or dies. Call it in the event-loop task that creates the worker,
 * so that it misses no event.
 *
 * @param makeError makes the error. Receives the browser's error message, if there is one.
 * @param signal aborting it ends the detection. The promise then rejects with the signal's reason.
 */
export function deathOf(
  worker: Worker,
  makeError: (reason: string | undefined) => Error,
  signal: AbortSignal,
): Promise<never> {
  const end = new Promise<never>((_, reject) => {
    signal.addEventListener('abort', () => reject(signal.reason), { once: true })
    worker.addEventListener(
      'error',
      (event) => {
        // Keep the error out of the console, because the promise reports it.
        event.preventDefault()
        reject(makeError(event.message))
      },
      { signal },
    )
    worker.addEventListener(
      'message',
      ({ data }: MessageEvent<Partial<Alive>>) => {
        if (data?.lock === undefined) return
        // The request rejects when `signal` aborts. Ignore this, because `end` also rejects.
        navigator.locks.request(data.lock, { signal }, () => reject(makeError(undefined))).catch(() => {})
      },
      { signal },
    )
  })
  // The promise may reject after the caller's `Promise.race` has ended. This handler prevents an unhandled rejection then.
  end.catch(() => {})
  return end
}
