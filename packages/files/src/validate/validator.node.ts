import { createRequire } from 'node:module'
import { Worker } from 'node:worker_threads'
import type { ValidatorOutcome, ValidatorTask } from './validator-task.ts'

/**
 * Source code of the thread that runs the Khronos validator. On damaged images and misaligned accessors the validator
 * throws outside its promise. After that it may still report, or the thread exits without a report. `runValidator`
 * handles both.
 */
const THREAD = `
  const { posix } = require('node:path')
  const { parentPort, workerData } = require('node:worker_threads')
  const { bytes, files, maxIssues, module } = workerData
  process.on('uncaughtException', (error) => parentPort.postMessage({ failure: String(error) }))
  const externalResourceFunction = async (uri) => files.get(posix.normalize(decodeURIComponent(uri)))
  require(module)
    .validateBytes(bytes, { maxIssues, externalResourceFunction })
    .then(({ issues }) => parentPort.postMessage({ issues: issues.messages }))`

/** Runs the Khronos validator in a separate thread, for at most `seconds`. */
export function runValidator(task: ValidatorTask, seconds: number): Promise<ValidatorOutcome> {
  const module = createRequire(import.meta.url).resolve('gltf-validator')
  const thread = new Worker(THREAD, {
    eval: true,
    workerData: { ...task, module },
    transferList: [task.bytes.buffer],
  })
  const outcome: ValidatorOutcome = { failure: 'it ended without a report' }
  return new Promise((resolve) => {
    const timer = setTimeout(() => {
      outcome.failure = `it took more than ${seconds} seconds`
      thread.terminate()
    }, seconds * 1000)
    thread.on('message', (message: ValidatorOutcome) => {
      Object.assign(outcome, message)
      if (outcome.issues) thread.terminate()
    })
    thread.on('error', (error) => {
      outcome.failure = String(error)
    })
    thread.on('exit', () => {
      clearTimeout(timer)
      resolve(outcome)
    })
  })
}
