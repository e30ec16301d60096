import { type Remote, wrap } from 'comlink'
import { endOf } from './life.ts'

/**
 * Asks one thing of a worker, which ends with it. It is to be called in the task that made the worker.
 *
 * @param died makes the error where the worker ends by itself, of what the browser says about that.
 * @param signal ends the worker when it is aborted; the promise rejects with its reason.
 */
export async function runOnce<Service, T>(
  worker: Worker,
  task: (service: Remote<Service>) => Promise<T>,
  died: (reason: string | undefined) => Error,
  signal?: AbortSignal,
): Promise<T> {
  const done = new AbortController()
  const ended = endOf(worker, died, done.signal)
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
