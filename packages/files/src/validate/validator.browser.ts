import type { ValidatorOutcome, ValidatorTask } from './validator-task.ts'

/** Time in which the validator may still report after an uncaught error. */
const SECONDS_AFTER_ERROR = 2

/**
 * Runs the Khronos validator in a separate worker, for at most `seconds`. On damaged images and misaligned accessors
 * the validator throws outside its promise. After that it may still report, or never respond.
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
