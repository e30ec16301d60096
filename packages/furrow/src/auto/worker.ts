/** Web worker that makes wrinkles and recognises blendshapes. `runWorker` starts it. */

import { type AutoProgress, autoWrinkles } from '../author/auto/auto.ts'
import { recogniseShapes } from '../author/shapes/recognise.ts'
import { FurrowError } from '../core/error.ts'
import { buffersOf } from './buffers.ts'
import { type MeshWrinkles, makeCharacterWrinkles } from './make-wrinkles.ts'
import type { AutoReply, AutoRequest, AutoResults } from './messages.ts'

addEventListener('message', ({ data }: MessageEvent<AutoRequest>) => {
  if (!data.lock) return run(data)
  // The promise never resolves, so the worker holds the lock until it ends.
  const hold = () => {
    void run(data)
    return new Promise(() => {})
  }
  navigator.locks.request(data.lock, hold).catch(() => run({ ...data, lock: undefined }))
})

async function run(request: AutoRequest): Promise<void> {
  reply({ type: 'started', lock: request.lock })
  try {
    await work(request)
    reply({ type: 'finished' })
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error)
    reply(
      error instanceof FurrowError
        ? { type: 'failed', parts: { ...error }, message }
        : { type: 'failed', message },
    )
  }
}

async function work(request: AutoRequest): Promise<void> {
  const { options } = request
  const progress: AutoProgress = (done, total, step) => reply({ type: 'progress', done, total, step })
  if (request.type === 'shapes') replyResult(recogniseShapes(request.skin).shapes)
  else if (request.type === 'skin') replyResult(autoWrinkles(request.skin, options, progress))
  else {
    const part = (part: MeshWrinkles) => reply({ type: 'part', part })
    const { character, version } = request
    const { notes, kept } = await makeCharacterWrinkles(character, options, version, progress, part)
    replyResult(notes)
    await kept
  }
}

function replyResult(result: AutoResults[keyof AutoResults]): void {
  reply({ type: 'made', result })
}

function reply(message: AutoReply): void {
  postMessage(message, {
    transfer: message.type === 'made' || message.type === 'part' ? buffersOf(message) : [],
  })
}
