import { mkdtemp, readFile, rm } from 'node:fs/promises'
import { extname, join, resolve } from 'node:path'
import { performance } from 'node:perf_hooks'
import { patiently } from '../places/passing.ts'
import { placeOf } from '../places/places.ts'
import type { ProcessEnd, ProcessLimits, ProcessPool } from '../processes/process-pool.ts'
import type { Job, Outcome } from './job.ts'
import { JOB_COMMANDS, type JobCommand } from './job-commands.ts'
import { wordsOf } from './job-options.ts'

/** What jobs run in. */
export interface Workshop {
  pool: Pick<ProcessPool, 'run'>
  limits: ProcessLimits
  /** A private folder: each job has one of its own in it while it runs. */
  scratch: string
}

/** A job fails at most so often because of its process: the next one is fresh, and may have more of the machine's memory. */
const MOST_PROCESSES = 2

/** Runs a job to its end. It does not throw: whatever fails is the outcome. */
export async function runJob(job: Job, workshop: Workshop): Promise<Outcome> {
  const start = performance.now()
  const progress = { attempts: 0 }
  const seconds = () => Number(((performance.now() - start) / 1000).toFixed(2))
  let folder: string | undefined
  try {
    folder = await mkdtemp(join(workshop.scratch, 'job-'))
    const outcome = await attempt(job, workshop, folder, progress)
    return { ...outcome, seconds: seconds(), ...progress }
  } catch (error) {
    // Reading the input and writing the output, which were tried again where that could help.
    return { ...machineFailure(error), seconds: seconds(), ...progress }
  } finally {
    // Removes half-written files of an ended process too.
    if (folder !== undefined)
      await rm(folder, { recursive: true, force: true, maxRetries: 5 }).catch(() => {})
  }
}

/** The outcome of what failed outside of a process: an input that cannot be reached today may be there tomorrow. */
export function machineFailure(
  error: unknown,
): Required<Pick<Outcome, 'status' | 'kind' | 'reason' | 'warnings'>> {
  const reason = error instanceof Error ? error.message : String(error)
  return { status: 'failed', kind: 'machine', reason, warnings: [] }
}

async function attempt(
  job: Job,
  { pool, limits }: Workshop,
  folder: string,
  progress: { attempts: number },
): Promise<Omit<Outcome, 'seconds' | 'attempts'>> {
  const command: JobCommand = JOB_COMMANDS[job.command]
  const path = await patiently(() => placeOf(job.input).fetch(job.input, job.identity, command.reads, folder))
  const target = job.output === undefined ? undefined : join(folder, `output${extname(job.output)}`)
  const input = resolve(path)
  const words = [
    input,
    ...wordsOf(job.options),
    '--json',
    ...(target === undefined ? [] : ['--output', target]),
  ]
  let end: ProcessEnd
  do {
    progress.attempts++
    end = await pool.run({ command: job.command, words })
  } while ((end.end === 'crash' || end.end === 'memory') && progress.attempts < MOST_PROCESSES)
  if (end.end !== 'report') return { status: 'failed', ...limitFailure(end, limits), warnings: [] }
  const { report } = end
  // Users know files by their addresses.
  const told = (text: string) =>
    text.replaceAll(input, job.input).replaceAll(target ?? input, job.output ?? job.input)
  const warnings = report.warnings.map(told)
  const { memory } = report
  if (report.failure !== undefined) {
    const kind = report.isBug ? 'crash' : report.isMachine ? 'machine' : 'file'
    return { status: 'failed', reason: told(report.failure), kind, warnings, memory }
  }
  const result = command.summary(JSON.parse(report.lines.join('\n')))
  if (report.exitCode !== 0) {
    return { status: 'failed', reason: `${result.errors} errors`, kind: 'file', warnings, result, memory }
  }
  if (target === undefined) return { status: 'done', warnings, result, memory }
  const bytes = await readFile(target)
  await patiently(() => placeOf(job.output!).put(job.output!, bytes))
  return { status: 'done', warnings, result, bytes: bytes.length, memory }
}

function limitFailure(end: Exclude<ProcessEnd, { end: 'report' }>, { memory, seconds }: ProcessLimits) {
  if (end.end === 'crash') return { kind: 'crash', reason: `its process ended (${end.reason})` } as const
  const reason =
    end.end === 'time'
      ? `it took more than ${seconds} s; give more with --timeout`
      : `it took more than ${Math.round(memory / 2 ** 20)} MB of memory; give more with --memory`
  return { kind: end.end, reason } as const
}
