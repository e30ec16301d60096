/** The worker of `autoWrinklesInWorker`. */

import { autoWrinkles } from '../author/auto/auto.ts'
import { FurrowError } from '../core/error.ts'
import { buffersOf } from './buffers.ts'
import type { AutoReply, AutoRequest } from './messages.ts'

addEventListener('message', ({ data }: MessageEvent<AutoRequest>) => {
  const { lock } = data
  if (!lock) return run(data)
  // Held until the worker ends.
  const hold = () => {
    run(data)
    return new Promise(() => {})
  }
  navigator.locks.request(lock, hold).catch(() => run({ ...data, lock: undefined }))
})

function run({ skin, options, lock }: AutoRequest): void {
  reply({ type: 'started', lock })
  try {
    const wrinkles = autoWrinkles(skin, options, (done, total, step) =>
      reply({ type: 'progress', done, total, step }),
    )
    reply({ type: 'made', wrinkles })
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error)
    reply(
      error instanceof FurrowError
        ? { type: 'failed', parts: { ...error }, message }
        : { type: 'failed', message },
    )
  }
}

function reply(message: AutoReply): void {
  postMessage(message, { transfer: message.type === 'made' ? buffersOf(message) : [] })
}
