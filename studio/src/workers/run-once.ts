import { type Remote, wrap } from 'comlink'
import { deathOf } from './life.ts'

/**
 * Runs one task in a worker and terminates the worker. Call immediately after creating the worker.
 *
 * @param makeError makes the error if the worker dies. Receives the browser's error message, if there is one.
 * @param signal aborting it terminates the worker. The promise then rejects with the signal's reason.
 */
export async function runOnce<Service, T>(
  worker: Worker,
  task: (service: Remote<Service>) => Promise<T>,
  makeError: (reason: string | undefined) => Error,
  signal?: AbortSignal,
): Promise<T> {
  const done = new AbortController()
  const ended = deathOf(worker, makeError, done.signal)
  const cancelled = new Promise<never>((_, reject) => {
    signal?.addEventListener('abort', () => reject(signal.reason), { signal: done.signal })
  })
  try {
    return await Promise.race([task(wrap<Service>(worker)), ended, cancelled])
  } finally {
    done.abort()
    worker.terminate()
  }
}
