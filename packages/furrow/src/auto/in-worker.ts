import type { AutoOptions, AutoProgress, AutoWrinkles } from '../author/auto/auto.ts'
import type { Skin } from '../author/skin/surface.ts'
import { FurrowError } from '../core/error.ts'
import { buffersOf } from './buffers.ts'
import type { AutoReply, AutoRequest } from './messages.ts'

const WHO = 'autoWrinklesInWorker'

/** Settings of `autoWrinklesInWorker`. */
export interface AutoInWorkerOptions extends AutoOptions {
  /** Called before each step and at the end. */
  progress?: AutoProgress
  /** Ends the worker when it is aborted. */
  signal?: AbortSignal
  /** Moves the skin's arrays to the worker without copying them: they and all views of their buffers are then empty. */
  transfer?: boolean
}

/**
 * Makes wrinkles from a character's own blendshapes as `autoWrinkles` does, bit for bit, in a web worker of its own. The page goes on
 * meanwhile. The result's arrays are moved here without copying them.
 *
 * A Content-Security-Policy must allow `worker-src blob:`, as it must for three.js's own decoders of KTX 2 and Draco.
 *
 * @returns a promise that rejects with a FurrowError where `autoWrinkles` throws it, where there are no workers, as in Node, and where the
 *   worker cannot start or dies; with the signal's reason when that is aborted.
 */
export async function autoWrinklesInWorker(
  skin: Skin,
  { progress, signal, transfer = false, ...options }: AutoInWorkerOptions = {},
): Promise<AutoWrinkles> {
  signal?.throwIfAborted()
  if (typeof Worker === 'undefined') throw withoutWorkers()
  const { startWorker } = await import('./start-worker.ts')
  signal?.throwIfAborted()
  const worker = start(startWorker)
  const ended = new AbortController()
  try {
    return await new Promise((resolve, reject) => {
      signal?.addEventListener('abort', () => reject(signal.reason), { signal: ended.signal })
      let isRunning = false
      worker.onerror = (event) => {
        // The promise tells it; the console need not.
        event.preventDefault()
        reject(isRunning ? died(event.message) : cannotStart(event.message))
      }
      worker.onmessage = ({ data }: MessageEvent<AutoReply>) => {
        if (data.type === 'started') {
          isRunning = true
          if (data.lock) whenFree(data.lock, ended.signal, () => reject(died()))
        } else if (data.type === 'progress') progress?.(data.done, data.total, data.step)
        else if (data.type === 'made') resolve(data.wrinkles)
        else reject(data.parts ? new FurrowError(data.parts) : died(data.message))
      }
      send(worker, { skin, options, lock: globalThis.navigator?.locks && crypto.randomUUID() }, transfer)
    })
  } finally {
    ended.abort()
    worker.terminate()
  }
}

function start(startWorker: () => Worker): Worker {
  try {
    return startWorker()
  } catch (error) {
    throw cannotStart((error as Error)?.message)
  }
}

function send(worker: Worker, request: AutoRequest, transfer: boolean): void {
  try {
    worker.postMessage(request, transfer ? buffersOf(request.skin) : [])
  } catch (error) {
    throw new FurrowError({
      who: WHO,
      what: 'the skin cannot be sent to the worker',
      value: (error as Error)?.message,
      remedy: 'pass arrays of numbers that were not transferred before',
    })
  }
}

/**
 * Calls a function when the worker is gone that holds a lock: browsers end workers without any event, as when memory runs out, but
 * they release what it held.
 */
function whenFree(lock: string, signal: AbortSignal, call: () => void): void {
  // Rejects when the signal ends the wait, and in documents without an origin of their own, which have no locks.
  navigator.locks.request(lock, { signal }, call).catch(() => {})
}

function withoutWorkers(): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: WHO,
    what: 'there are no web workers here',
    remedy: 'call autoWrinkles of furrow/author, which runs anywhere',
  })
}

function cannotStart(message: string | undefined): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: WHO,
    what: 'the worker cannot be started',
    value: message,
    remedy: 'allow `worker-src blob:` in the Content-Security-Policy of the page',
  })
}

function died(message?: string): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: WHO,
    what: 'the worker ended before the wrinkles were made',
    value: message,
    remedy: 'close other pages to free memory, or choose a smaller size',
  })
}
