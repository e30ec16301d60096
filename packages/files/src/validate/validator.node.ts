import { createRequire } from 'node:module'
import { Worker } from 'node:worker_threads'
import type { ValidatorOutcome, ValidatorTask } from './validator-task.ts'

/**
 * The thread that the validator runs in. Damaged images and misaligned accessors make it throw outside of its promise, and then it
 * goes on to report, or ends without a word: either is seen from outside.
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

/** Runs the Khronos validator in a thread of its own, for so many seconds at most. */
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
