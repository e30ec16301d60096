import { createRequire } from 'node:module'
import { posix } from 'node:path'
import { Worker } from 'node:worker_threads'
import { WRINKLE_MAPS } from 'furrow'
import type { Issue } from 'gltf-validator'
import { unescaped } from '../gltf/external-files.ts'
import type { Glb } from '../gltf/glb-file.ts'
import { errorFinding, type Finding, warningFinding } from './finding.ts'

/** Limit of the Khronos validator. */
const MAX_ISSUES = 1000

/** It takes about a tenth of this. */
const SECONDS = 10
const SECONDS_PER_MB = 1

/** Code of the finding that the validator did not come to its end. */
export const GAVE_UP = 'VALIDATOR'

/** Codes of the Khronos validator for images in a format that it does not know. */
const UNKNOWN_FORMAT = ['VALUE_NOT_IN_LIST', 'IMAGE_UNRECOGNIZED_FORMAT']

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

/**
 * Errors and warnings of the Khronos validator, except those about what it does not know: the extension and KTX 2 images, which
 * `checkWrinkles` checks.
 *
 * @param glb as `readGlbFile` reads it; the file is validated as it was before its parts were joined.
 */
export async function runKhronosValidator({ json, bytes, references }: Glb): Promise<Finding[]> {
  const { issues, failure } = await runThread(Uint8Array.from(bytes), filesOf(references))
  if (!issues) return [errorFinding(GAVE_UP, `the Khronos validator gave up: ${failure}`)]
  return issues
    .filter(({ severity, message }) => severity < 2 && !message.includes(WRINKLE_MAPS))
    .filter(({ code, pointer = '' }) => {
      const image = json.images?.[Number(/^\/images\/(\d+)/.exec(pointer)?.[1])]
      return !(UNKNOWN_FORMAT.includes(code) && image?.mimeType === 'image/ktx2')
    })
    .map(({ code, message, severity, pointer }) => {
      return (severity === 0 ? errorFinding : warningFinding)(code, message, pointer)
    })
}

/** The files that a file refers to by their paths: the validator asks for them by URIs that it has normalised. */
function filesOf(references: Glb['references']): Map<string, Uint8Array> {
  const files = [...references].filter(([, { path }]) => path !== undefined)
  return new Map(
    files.map(([uri, { bytes }]) => [posix.normalize(unescaped(uri).replaceAll('\\', '/')), bytes]),
  )
}

interface Outcome {
  issues?: Issue[]
  failure?: string
}

function runThread(bytes: Uint8Array, files: Map<string, Uint8Array>): Promise<Outcome> {
  const size = bytes.length
  const module = createRequire(import.meta.url).resolve('gltf-validator')
  const thread = new Worker(THREAD, {
    eval: true,
    workerData: { bytes, files, maxIssues: MAX_ISSUES, module },
    transferList: [bytes.buffer as ArrayBuffer],
  })
  const seconds = Math.ceil(SECONDS + (SECONDS_PER_MB * size) / 1e6)
  const outcome: Outcome = { failure: 'it ended without a report' }
  return new Promise((resolve) => {
    const timer = setTimeout(() => {
      outcome.failure = `it took more than ${seconds} seconds`
      thread.terminate()
    }, seconds * 1000)
    thread.on('message', (message: Outcome) => {
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
