import { resolve } from 'node:path'
import { FurrowError } from 'furrow'
import { realTarget } from '../outputs.ts'
import type { Entry } from './inputs/entry.ts'
import { type Job, keyOf } from './jobs/job.ts'
import { JOB_COMMANDS, type JobCommandName } from './jobs/job-commands.ts'
import type { JobOptions } from './jobs/job-options.ts'
import { machineFailure } from './jobs/run-job.ts'
import { lineId, type ResultLine } from './results.ts'
import { runConcurrently } from './run-concurrently.ts'
import { filesRead } from './stores/local-files.ts'
import { withRetries } from './stores/retries.ts'
import { isRemote, storeOf } from './stores/store-of.ts'

const WHO = 'furrow batch'

const READ_AT_ONCE = 16

/**
 * A job, and all inputs that have the same content and options. The job runs for the first input. Its output is copied
 * for the other inputs.
 */
export interface Task {
  job: Job
  entries: readonly Pick<Entry, 'input' | 'output'>[]
}

/** Tasks that a batch has to run, and results that are already known. */
export interface Plan {
  tasks: Task[]
  /** Results of inputs that cannot be read. */
  failed: ResultLine[]
  /** Results of an earlier run that are still valid. */
  kept: ResultLine[]
}

export interface PlanSource {
  command: JobCommandName
  version: string
  /** Results of earlier runs by line id, see `readResults`. */
  earlier: ReadonlyMap<string, ResultLine>
  progress: (done: number) => void
}

/**
 * Throws if two inputs have the same output, or if an output is a file that the command reads. Resolves symbolic links.
 */
export async function checkEntries(entries: readonly Entry[], command: JobCommandName): Promise<void> {
  const written = entries.filter(({ output }) => output !== undefined)
  if (written.length === 0) return
  const inputs = new Set(await fileKeys(await filesOfEntries(entries, command)))
  const keys = await fileKeys(written.map(({ output }) => output!))
  const outputs = new Map<string, string>()
  for (const [i, { input, output }] of written.entries()) {
    const key = keys[i]
    const outputError = (problem: string, remedy: string) => {
      return new FurrowError({ code: 'usage', who: WHO, problem, value: output, remedy })
    }
    const other = outputs.get(key)
    if (other !== undefined) {
      throw outputError(
        `${other} and ${input} have the same output`,
        'set the outputs in a manifest, or select the inputs with a pattern',
      )
    }
    if (inputs.has(key))
      throw outputError('an output is a file that the batch reads', 'choose another output folder')
    outputs.set(key, input)
  }
}

/** Returns the paths of all files that the command reads: inputs, files in options, and files that these reference. */
async function filesOfEntries(entries: readonly Entry[], command: JobCommandName): Promise<string[]> {
  const { reads, files } = JOB_COMMANDS[command]
  const faces = files.flatMap((name) => entries.map(({ options }) => String(options[name] ?? '')))
  const read = [
    ...entries.map(({ input }) => ({ path: input, reads })),
    ...[...new Set(faces)].filter(Boolean).map((path) => ({ path, reads: 'file' as const })),
  ]
  const found: string[][] = []
  await runConcurrently(read, READ_AT_ONCE, async ({ path, reads }) => {
    // The job reports unreadable inputs.
    found.push(isRemote(path) ? [path] : await filesRead(path, reads).catch(() => [path]))
  })
  return [...new Set(found.flat())]
}

/** Returns a key per address. All paths to the same file have the same key. */
async function fileKeys(addresses: readonly string[]): Promise<string[]> {
  const keys = [...addresses]
  await runConcurrently(addresses, READ_AT_ONCE, async (address, i) => {
    // The job reports paths that cannot be resolved.
    if (!isRemote(address)) keys[i] = await realTarget(address).catch(() => resolve(address))
  })
  return keys
}

/** Identifies the content of all inputs, and decides which jobs have to run. */
export async function makePlan(entries: readonly Entry[], source: PlanSource): Promise<Plan> {
  const { command, version, earlier, progress } = source
  const jobs = new Array<Job | undefined>(entries.length)
  const plan: Plan = { tasks: [], failed: [], kept: [] }
  const optionFiles = new Map<string, Promise<string>>()
  let done = 0
  await runConcurrently(entries, READ_AT_ONCE, async (entry, i) => {
    const { input, output, options } = entry
    try {
      const store = storeOf(input)
      const { reads } = JOB_COMMANDS[command]
      const identity = entry.identity ?? (await withRetries(() => store.identify(input, reads)))
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
  const valid = new Array<ResultLine | undefined>(jobs.length)
  await runConcurrently(jobs, READ_AT_ONCE, async (job, i) => {
    const line = job && earlier.get(lineId(job))
    if (line && (await isStillValid(line, job))) valid[i] = line
  })
  plan.kept = valid.filter((line) => line !== undefined)
  const groups = new Map<string, { job: Job; entries: Task['entries'][number][] }>()
  for (const [i, job] of jobs.entries()) {
    if (!job || valid[i]) continue
    const group = groups.get(job.key) ?? { job, entries: [] }
    group.entries.push({ input: job.input, ...(job.output !== undefined && { output: job.output }) })
    groups.set(job.key, group)
  }
  plan.tasks = [...groups.values()]
  return plan
}

/**
 * Replaces file paths in options, e.g. in `--face`, with content identities, because a file can change between runs.
 */
async function contentOptions(
  command: JobCommandName,
  options: JobOptions,
  known: Map<string, Promise<string>>,
): Promise<JobOptions> {
  const names: readonly string[] = JOB_COMMANDS[command].files
  const pairs = Object.entries(options).map(async ([name, value]) => {
    if (!names.includes(name) || typeof value !== 'string') return [name, value] as const
    const identity = known.get(value) ?? storeOf(value).identify(value, 'file')
    known.set(value, identity)
    return [name, await identity] as const
  })
  return Object.fromEntries(await Promise.all(pairs))
}

/**
 * Returns whether an earlier result is still valid. A failure stays valid if an invalid input caused it. A success
 * stays valid if the output still has the same size. Its content is not compared: outputs are written atomically, so an
 * interruption leaves no partial output.
 */
async function isStillValid({ status, kind, bytes }: ResultLine, { output }: Job): Promise<boolean> {
  if (status === 'failed') return kind === 'file'
  if (output === undefined) return true
  return (await withRetries(() => storeOf(output).sizeOf(output))) === bytes
}
