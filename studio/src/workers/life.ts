/**
 * Detection of dead workers. Browsers can end workers without an event, for example when memory runs out, but then release their locks. Each
 * worker holds a lock, and the page waits for that lock.
 */

/** First message of a worker: the name of its lock. */
interface Alive {
  lock: string
}

/** Holds a lock in a worker, so that the page detects its end. On insecure pages, which lack locks, the page detects only errors. */
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
 * Returns a promise that rejects if a worker cannot be loaded or dies. Call in the task that created the worker.
 *
 * @param makeError makes the error from the browser's reason, if any.
 * @param signal ends the wait. The promise then rejects with its reason.
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
        // The request rejects when `signal` aborts. `end` reports that.
        navigator.locks.request(data.lock, { signal }, () => reject(makeError(undefined))).catch(() => {})
      },
      { signal },
    )
  })
  // Prevent an unhandled rejection if the caller only races this promise.
  end.catch(() => {})
  return end
}
