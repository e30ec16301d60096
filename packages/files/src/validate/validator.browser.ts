import type { ValidatorOutcome, ValidatorTask } from './validator-task.ts'

/** When it has thrown, it reports within this time or never. */
const SECONDS_AFTER_ERROR = 2

/**
 * Runs the Khronos validator in a worker of its own, for so many seconds at most. Damaged images and misaligned accessors make
 * it throw outside of its promise, and then it goes on to report, or says no more.
 */
export function runValidator(task: ValidatorTask, seconds: number): Promise<ValidatorOutcome> {
  const worker = new Worker(new URL('./validator-worker.ts', import.meta.url), { type: 'module' })
  return new Promise((resolve) => {
    let timer: ReturnType<typeof setTimeout>
    const end = (outcome: ValidatorOutcome) => {
      clearTimeout(timer)
      worker.terminate()
      resolve(outcome)
    }
    const endAfter = (seconds: number, failure: string) => {
      clearTimeout(timer)
      timer = setTimeout(() => end({ failure }), seconds * 1000)
    }
    endAfter(seconds, `it took more than ${seconds} seconds`)
    worker.onmessage = ({ data }: MessageEvent<ValidatorOutcome>) => {
      if (data.issues) end(data)
      else endAfter(SECONDS_AFTER_ERROR, data.failure!)
    }
    worker.onerror = ({ message }) => endAfter(SECONDS_AFTER_ERROR, message)
    worker.postMessage(task, [task.bytes.buffer])
  })
}
