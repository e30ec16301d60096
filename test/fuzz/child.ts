// Entry of a process that runs commands on damaged files. `pool.ts` starts it, sends tasks and receives results as messages.

import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { join } from 'node:path'
import { Worker } from 'node:worker_threads'
import { FurrowError } from 'furrow'
import { parseWrinkledFile, wrinkledMaterials } from 'furrow-files'
import { readGlbFile } from 'furrow-files/node'
import { validateBytes } from 'gltf-validator'
import { strokesIn } from '../../packages/files/src/wrinkles/strokes.ts'
import { readBases } from './bases.ts'
import { type Case, makeCase } from './cases.ts'
import { peakMemory } from './peak-memory.ts'
import { quietly } from './quietly.ts'
import { Random } from './random.ts'

/** Describes one damaged file, which depends only on `command`, `seed` and `index`. */
export interface Task {
  command: string
  seed: number
  index: number
  /** Processor time after which the process ends itself, seconds. */
  seconds: number
  /** Folder for the task's files. It is emptied first, and kept afterwards for inspection. */
  folder: string
}

/** Outcome of a run. Only `success`, `refused` and `findings` are expected. */
export type Outcome =
  | 'success'
  | 'refused'
  | 'findings'
  | 'stack'
  | 'unclear error'
  | 'left files'
  | 'invalid output'
  | 'too slow'
  | 'too large'
  | 'died'

export interface Result {
  outcome: Outcome
  /** Text of the error, or the problems in the output. */
  message: string
  /** Processor time. Wall time would depend on other processes. */
  milliseconds: number
  /** Total size of the input files, bytes. */
  bytes: number
  /** Peak resident memory of the process so far, bytes. */
  peak: number
}

/** Processor time at which this process ends, milliseconds. A second thread checks it, because an endless loop blocks the main thread. */
const deadline = new Float64Array(new SharedArrayBuffer(8)).fill(Number.POSITIVE_INFINITY)
const WATCH = `
  const { workerData } = require('node:worker_threads')
  setInterval(() => {
    const { user, system } = process.cpuUsage()
    if ((user + system) / 1000 > workerData[0]) process.kill(process.pid, 'SIGKILL')
  }, 200)`
new Worker(WATCH, { eval: true, workerData: deadline }).unref()

// No browser is at this path, so reports get no pictures. A browser per report would take seconds.
process.env.FURROW_CHROMIUM = process.argv[2]!

const bases = readBases(process.argv[2]!)

process.on('message', async (task: Task) => {
  process.send!(await attempt(task))
})

async function attempt({ command, seed, index, seconds, folder }: Task): Promise<Result> {
  rmSync(folder, { recursive: true, force: true })
  mkdirSync(folder, { recursive: true })
  const random = new Random(hashOf(`${seed} ${command} ${index}`))
  const made = makeCase(command, bases, random, folder)
  const before = readdirSync(folder, { recursive: true }).length
  process.exitCode = undefined
  const start = process.cpuUsage()
  deadline[0] = (start.user + start.system) / 1000 + 1000 * seconds
  let outcome: Outcome = 'success'
  let message = ''
  try {
    await quietly(made.run)
    if (process.exitCode === 1) outcome = 'findings'
  } catch (error) {
    ;[outcome, message] = judge(error)
  }
  const { user, system } = process.cpuUsage(start)
  const milliseconds = (user + system) / 1000
  deadline[0] = Number.POSITIVE_INFINITY
  process.exitCode = undefined
  if (outcome === 'refused' && readdirSync(folder, { recursive: true }).length !== before)
    outcome = 'left files'
  if (outcome === 'success') message = await newErrors(made)
  if (message && outcome === 'success') outcome = 'invalid output'
  const peak = peakMemory()
  return { outcome, message, milliseconds, bytes: made.bytes, peak }
}

/** Matches internal messages of JavaScript engines and libraries, which do not help users. */
const UNCLEAR = /undefined|of null|is not (a function|iterable)|\[object|typed array|call stack/i

function judge(error: unknown): [Outcome, string] {
  if (!(error instanceof FurrowError)) return ['stack', error instanceof Error ? error.stack! : String(error)]
  return [UNCLEAR.test(error.message) ? 'unclear error' : 'refused', error.message]
}

/** Returns the problems that a command has added: error codes of the Khronos validator, and stroke problems. */
async function newErrors({ faces }: Case): Promise<string> {
  const found: string[] = []
  for (const { output, input } of faces) {
    if (!existsSync(output)) continue
    const known = await strokeProblems(input)
    found.push(...(await strokeProblems(output)).filter((problem) => !known.includes(problem)))
    const [old, now] = [await errorsOf(input), await errorsOf(output)]
    if (!old || !now) continue
    // In a file with errors, the validator may skip checks of accessor data. So errors of accessors count only if the input has no errors.
    const isNew = (code: string) => !old.includes(code) && !(old.length > 0 && code.startsWith('ACCESSOR_'))
    found.push(...now.filter(isNew))
  }
  return [...new Set(found)].join(', ')
}

async function strokeProblems(path: string): Promise<string[]> {
  try {
    const glb = await readGlbFile(path, 'strokes')
    const files = wrinkledMaterials(glb).map((material) => parseWrinkledFile(glb, material, 'strokes'))
    return files.flatMap((file) => strokesIn(file, 'strokes').problem ?? [])
  } catch {
    // The file is damaged outside the strokes, and the validator reports this damage.
    return []
  }
}

let giveUp = () => {}
process.on('uncaughtException', (error: NodeJS.ErrnoException) => {
  // The validator also throws values that are not an `Error` and have no stack.
  const isValidators = error.code === 'ERR_UNHANDLED_REJECTION' || error.stack?.includes('gltf_validator')
  if (!isValidators) throw error
  giveUp()
})

/**
 * Returns the errors of the Khronos validator, or undefined if the validator fails. For damaged JSON, the promise of `validateBytes` rejects.
 * For damaged images, the validator throws outside of this promise, and the promise may never settle.
 */
async function errorsOf(path: string): Promise<string[] | undefined> {
  const bytes = new Uint8Array(readFileSync(path))
  // Copies the bytes, because Node puts small files into a shared buffer, and the validator reads from the start of the buffer.
  const readBeside = async (uri: string) =>
    new Uint8Array(readFileSync(join(path, '..', decodeURIComponent(uri))))
  const report = await new Promise<Report | undefined>((resolve) => {
    giveUp = () => resolve(undefined)
    // 0 removes the limit on the number of issues. A limit could hide an error of the input. The same error in the output would then count as new.
    validateBytes(bytes, { maxIssues: 0, externalResourceFunction: readBeside }).then(resolve, giveUp)
  })
  const errors = report?.issues.messages.filter(
    ({ severity, message }) => severity === 0 && !message.includes('ktx2'),
  )
  // Shortens JSON pointers, because a command may renumber items and move an image from a buffer view to a file.
  const where = (pointer = '') => pointer.replaceAll(/\d+/g, 'n').replace(/\/(bufferView|uri)$/, '')
  return errors?.map(({ code, pointer }) => `${code} ${where(pointer)}`)
}

type Report = Awaited<ReturnType<typeof validateBytes>>

/** Computes the 32-bit FNV-1a hash of a text. */
function hashOf(text: string): number {
  let hash = 0x811c9dc5
  for (const byte of Buffer.from(text)) hash = Math.imul(hash ^ byte, 0x01000193)
  return hash >>> 0
}
