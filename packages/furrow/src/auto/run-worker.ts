import { FurrowError } from '../core/error.ts'
import type { MeshWrinkles } from './make-wrinkles.ts'
import type { AutoJob, AutoReply, AutoRequest, AutoResults } from './messages.ts'
import { type AutoRunOptions, checkRunOptions } from './run-options.ts'

/**
 * Starts a web worker, runs one job in it, and ends the worker.
 *
 * @param transfer buffers to transfer to the worker instead of copying them.
 * @param who name of the caller in errors.
 * @param received receives the wrinkles of one mesh of a character after another.
 * @returns a promise of the result. Rejects with the errors of the job, or with the signal's reason if aborted. Rejects with a FurrowError
 *   if an option is invalid, if there are no web workers, or if the worker cannot start or ends early.
 */
export async function runWorker<Job extends AutoJob>(
  job: Job,
  { progress, signal, ...options }: AutoRunOptions,
  transfer: ArrayBuffer[],
  who: string,
  received: (part: MeshWrinkles) => void = () => {},
): Promise<AutoResults[Job['type']]> {
  checkRunOptions(options, who)
  signal?.throwIfAborted()
  if (typeof Worker === 'undefined') throw withoutWorkers(who)
  const { startWorker, version } = await import('./start-worker.ts')
  signal?.throwIfAborted()
  const worker = start(startWorker, who)
  return new Promise((resolve, reject) => {
    const ended = new AbortController()
    const end = () => {
      ended.abort()
      worker.terminate()
    }
    const fail = (reason: unknown) => {
      end()
      reject(reason)
    }
    signal?.addEventListener('abort', () => fail(signal.reason), { signal: ended.signal })
    let isRunning = false
    worker.onerror = (event) => {
      // The browser must not log the error, because the promise reports it.
      event.preventDefault()
      fail(isRunning ? died(who, event.message) : cannotStart(who, event.message))
    }
    worker.onmessage = ({ data }: MessageEvent<AutoReply>) => {
      if (data.type === 'started') {
        isRunning = true
        if (data.lock) whenFree(data.lock, ended.signal, () => fail(died(who)))
      } else if (data.type === 'progress') progress?.(data.done, data.total, data.step)
      else if (data.type === 'part') received(data.part)
      else if (data.type === 'made') resolve(data.result as AutoResults[Job['type']])
      else if (data.type === 'finished') end()
      else fail(data.parts ? new FurrowError(data.parts) : died(who, data.message))
    }
    const lock = globalThis.navigator?.locks && crypto.randomUUID()
    const request: AutoRequest = { ...job, options, version, lock }
    try {
      worker.postMessage(request, transfer)
    } catch (error) {
      fail(notSent(who, (error as Error)?.message))
    }
  })
}

function start(startWorker: () => Worker, who: string): Worker {
  try {
    return startWorker()
  } catch (error) {
    throw cannotStart(who, (error as Error)?.message)
  }
}

/**
 * Calls a function when the worker that holds a lock has ended. If memory runs out, browsers end a worker without sending an event, but they
 * always release its locks.
 */
function whenFree(lock: string, signal: AbortSignal, call: () => void): void {
  // The promise rejects if the signal is aborted. It also rejects in documents with an opaque origin, which cannot use locks.
  navigator.locks.request(lock, { signal }, call).catch(() => {})
}

function withoutWorkers(who: string): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who,
    problem: 'web workers are not supported here',
    remedy: 'call autoWrinkles of furrow/author, which needs no worker',
  })
}

function notSent(who: string, message: string | undefined): FurrowError {
  return new FurrowError({
    who,
    problem: 'the skin cannot be sent to the worker',
    value: message,
    remedy: 'pass arrays of numbers that have not been transferred',
  })
}

function cannotStart(who: string, message: string | undefined): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who,
    problem: 'the worker cannot start',
    value: message,
    remedy: 'allow `worker-src blob:` in the Content-Security-Policy of the page',
  })
}

function died(who: string, message?: string): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who,
    problem: 'the worker ended before its work was done',
    value: message,
    remedy: 'close other pages to free memory, or choose smaller maps',
  })
}
