// Process that tries files; see pool.ts. Tasks and results are messages.

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

/** File to try. */
export interface Task {
  command: string
  seed: number
  index: number
  /** Processor time after which this process ends itself, seconds. */
  seconds: number
  /** Folder for the task's files: emptied first, and kept for inspection. */
  folder: string
}

/** Result of a run. `success`, `refused` and `findings` are expected. */
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
  /** Error, or problems found. */
  message: string
  /** Processor time, because wall time depends on other processes. */
  milliseconds: number
  /** Size of the files read, bytes. */
  bytes: number
  /** Peak resident memory of the process so far, bytes. */
  peak: number
}

/** Processor time at which this process ends, milliseconds. A thread checks the deadline, because a hanging file blocks this thread. */
const deadline = new Float64Array(new SharedArrayBuffer(8)).fill(Number.POSITIVE_INFINITY)
const WATCH = `
  const { workerData } = require('node:worker_threads')
  setInterval(() => {
    const { user, system } = process.cpuUsage()
    if ((user + system) / 1000 > workerData[0]) process.kill(process.pid, 'SIGKILL')
  }, 200)`
new Worker(WATCH, { eval: true, workerData: deadline }).unref()

// Reports have no pictures of the face: starting a browser would take seconds each time.
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

/** Messages of engines and libraries about unexpected values, which tell users nothing. */
const UNCLEAR = /undefined|of null|is not (a function|iterable)|\[object|typed array|call stack/i

function judge(error: unknown): [Outcome, string] {
  if (!(error instanceof FurrowError)) return ['stack', error instanceof Error ? error.stack! : String(error)]
  return [UNCLEAR.test(error.message) ? 'unclear error' : 'refused', error.message]
}

/** Returns the Khronos validator's codes and stroke problems that a command's output has and its input lacks. */
async function newErrors({ faces }: Case): Promise<string> {
  const found: string[] = []
  for (const { output, input } of faces) {
    if (!existsSync(output)) continue
    const known = await strokeProblems(input)
    found.push(...(await strokeProblems(output)).filter((problem) => !known.includes(problem)))
    const [old, now] = [await errorsOf(input), await errorsOf(output)]
    if (!old || !now) continue
    // The validator may skip data checks in a file with errors, so fixing those errors reveals others.
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
    // The validator reports the other problems of a face.
    return []
  }
}

let giveUp = () => {}
process.on('uncaughtException', (error: NodeJS.ErrnoException) => {
  // The validator also throws values that are not errors and have no stack.
  const isValidators = error.code === 'ERR_UNHANDLED_REJECTION' || error.stack?.includes('gltf_validator')
  if (!isValidators) throw error
  giveUp()
})

/**
 * Returns undefined if the validator gives up. Damaged JSON rejects the validator's promise. Damaged images make it
 * throw outside the promise, which may then never settle.
 */
async function errorsOf(path: string): Promise<string[] | undefined> {
  const bytes = new Uint8Array(readFileSync(path))
  // Copied, because the validator reads from the start of the buffer, and small files share a buffer.
  const readBeside = async (uri: string) =>
    new Uint8Array(readFileSync(join(path, '..', decodeURIComponent(uri))))
  const report = await new Promise<Report | undefined>((resolve) => {
    giveUp = () => resolve(undefined)
    // Unlimited: otherwise the last issues appear only after others are fixed.
    validateBytes(bytes, { maxIssues: 0, externalResourceFunction: readBeside }).then(resolve, giveUp)
  })
  const errors = report?.issues.messages.filter(
    ({ severity, message }) => severity === 0 && !message.includes('ktx2'),
  )
  // A command may move an image from a buffer view to a file.
  const where = (pointer = '') => pointer.replaceAll(/\d+/g, 'n').replace(/\/(bufferView|uri)$/, '')
  return errors?.map(({ code, pointer }) => `${code} ${where(pointer)}`)
}

type Report = Awaited<ReturnType<typeof validateBytes>>

/** FNV-1a. */
function hashOf(text: string): number {
  let hash = 0x811c9dc5
  for (const byte of Buffer.from(text)) hash = Math.imul(hash ^ byte, 0x01000193)
  return hash >>> 0
}
