import { resolve } from 'node:path'
import { FurrowError } from 'furrow'
import { realTarget } from '../outputs.ts'
import type { Entry } from './inputs/entry.ts'
import { type Job, keyOf } from './jobs/job.ts'
import { JOB_COMMANDS, type JobCommandName } from './jobs/job-commands.ts'
import type { JobOptions } from './jobs/job-options.ts'
import { machineFailure } from './jobs/run-job.ts'
import { inLanes } from './lanes.ts'
import { filesRead } from './places/files.ts'
import { patiently } from './places/passing.ts'
import { isRemote, placeOf } from './places/places.ts'
import { lineId, type ResultLine } from './results.ts'

const WHO = 'furrow batch'

/** Files that are read at the same time. */
const READ_AT_ONCE = 16

/** A job, and all inputs that it is the job of: the first one's output is made, and copied for the others. */
export interface Task {
  job: Job
  places: readonly Pick<Entry, 'input' | 'output'>[]
}

/** What is to be done. */
export interface Plan {
  tasks: Task[]
  /** What is known without any work: inputs that cannot be read. */
  failed: ResultLine[]
  /** Lines of results before this one that still hold. */
  kept: ResultLine[]
}

/** What a plan is made from besides the inputs. */
export interface PlanSource {
  command: JobCommandName
  /** Of this package. */
  version: string
  /** See `readResults`. */
  earlier: ReadonlyMap<string, ResultLine>
  progress: (done: number) => void
}

/**
 * Throws FurrowError where two inputs have one output, or an output is a file that the command reads, by links too: the result would depend on
 * which is first, and inputs would be lost.
 */
export async function checkEntries(entries: readonly Entry[], command: JobCommandName): Promise<void> {
  const written = entries.filter(({ output }) => output !== undefined)
  if (written.length === 0) return
  const inputs = new Set(await placeKeys(await filesOfEntries(entries, command)))
  const keys = await placeKeys(written.map(({ output }) => output!))
  const outputs = new Map<string, string>()
  for (const [i, { input, output }] of written.entries()) {
    const key = keys[i]
    const fault = (problem: string, remedy: string) => {
      return new FurrowError({ code: 'usage', who: WHO, problem, value: output, remedy })
    }
    const other = outputs.get(key)
    if (other !== undefined) {
      throw fault(
        `${other} and ${input} have one output`,
        'name each in a manifest, or choose them by a pattern',
      )
    }
    if (inputs.has(key)) throw fault('an output is an input', 'choose another folder of outputs')
    outputs.set(key, input)
  }
}

/** All that a command reads: inputs and the faces that options name, with the files that they refer to. */
async function filesOfEntries(entries: readonly Entry[], command: JobCommandName): Promise<string[]> {
  const { reads, files } = JOB_COMMANDS[command]
  const faces = files.flatMap((name) => entries.map(({ options }) => String(options[name] ?? '')))
  const read = [
    ...entries.map(({ input }) => ({ path: input, reads })),
    ...[...new Set(faces)].filter(Boolean).map((path) => ({ path, reads: 'file' as const })),
  ]
  const found: string[][] = []
  await inLanes(read, READ_AT_ONCE, async ({ path, reads }) => {
    // Where an input cannot be looked at, its job tells.
    found.push(isRemote(path) ? [path] : await filesRead(path, reads).catch(() => [path]))
  })
  return [...new Set(found.flat())]
}

/** The same text for the same place. */
async function placeKeys(addresses: readonly string[]): Promise<string[]> {
  const keys = [...addresses]
  await inLanes(addresses, READ_AT_ONCE, async (address, i) => {
    // What cannot be looked at cannot be written either, which its job tells.
    if (!isRemote(address)) keys[i] = await realTarget(address).catch(() => resolve(address))
  })
  return keys
}

/** Reads what all inputs are, and finds what is left to do. */
export async function makePlan(entries: readonly Entry[], source: PlanSource): Promise<Plan> {
  const { command, version, earlier, progress } = source
  const jobs = new Array<Job | undefined>(entries.length)
  const plan: Plan = { tasks: [], failed: [], kept: [] }
  const optionFiles = new Map<string, Promise<string>>()
  let done = 0
  await inLanes(entries, READ_AT_ONCE, async (entry, i) => {
    const { input, output, options } = entry
    try {
      const place = placeOf(input)
      const { reads } = JOB_COMMANDS[command]
      const identity = entry.identity ?? (await patiently(() => place.identify(input, reads)))
      const withContent = await contentOptions(command, options, optionFiles)
      const key = keyOf(version, { command, identity, options: withContent })
      jobs[i] = { key, command, input, identity, ...(output !== undefined && { output }), options }
    } catch (error) {
      plan.failed.push({
        command,
        input,
        ...(output && { output }),
        ...machineFailure(error),
        seconds: 0,
        attempts: 0,
      })
    }
    progress(++done)
  })
  const holding = new Array<ResultLine | undefined>(jobs.length)
  await inLanes(jobs, READ_AT_ONCE, async (job, i) => {
    const line = job && earlier.get(lineId(job))
    if (line && (await stillHolds(line, job))) holding[i] = line
  })
  plan.kept = holding.filter((line) => line !== undefined)
  const groups = new Map<string, { job: Job; places: Task['places'][number][] }>()
  for (const [i, job] of jobs.entries()) {
    if (!job || holding[i]) continue
    const group = groups.get(job.key) ?? { job, places: [] }
    group.places.push({ input: job.input, ...(job.output !== undefined && { output: job.output }) })
    groups.set(job.key, group)
  }
  plan.tasks = [...groups.values()]
  return plan
}

/** Options with what is in their files: a face that `--face` names can change under its name. */
async function contentOptions(
  command: JobCommandName,
  options: JobOptions,
  known: Map<string, Promise<string>>,
): Promise<JobOptions> {
  const names: readonly string[] = JOB_COMMANDS[command].files
  const pairs = Object.entries(options).map(async ([name, value]) => {
    if (!names.includes(name) || typeof value !== 'string') return [name, value] as const
    const identity = known.get(value) ?? placeOf(value).identify(value, 'file')
    known.set(value, identity)
    return [name, await identity] as const
  })
  return Object.fromEntries(await Promise.all(pairs))
}

/**
 * Whether a job need not be done again: its output is there as it was put, or its input was refused, which it would be again. An
 * output is put whole or not at all, so its size tells whether it is that one.
 */
async function stillHolds({ status, kind, bytes }: ResultLine, { output }: Job): Promise<boolean> {
  if (status === 'failed') return kind === 'file'
  if (output === undefined) return true
  return (await patiently(() => placeOf(output).sizeOf(output))) === bytes
}
