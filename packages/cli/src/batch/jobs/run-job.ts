import { mkdtemp, readFile, rm } from 'node:fs/promises'
import { extname, join, resolve } from 'node:path'
import { performance } from 'node:perf_hooks'
import type { ProcessEnd, ProcessLimits, ProcessPool } from '../processes/process-pool.ts'
import { withRetries } from '../stores/retries.ts'
import { storeOf } from '../stores/store-of.ts'
import type { Job, Outcome } from './job.ts'
import { JOB_COMMANDS, type JobCommand } from './job-commands.ts'
import { wordsOf } from './job-options.ts'

/** Processes, limits and temporary files for jobs on this machine. */
export interface JobEnvironment {
  pool: Pick<ProcessPool, 'run'>
  limits: ProcessLimits
  /** Private folder. Each running job has a subfolder in it. */
  scratch: string
}

/**
 * Maximum number of attempts if the process crashes or exceeds the memory limit. Each attempt after a failure gets a
 * new process.
 */
const MAX_ATTEMPTS = 2

/** Runs a job. Never throws: an error becomes an outcome with the status `failed`. */
export async function runJob(job: Job, environment: JobEnvironment): Promise<Outcome> {
  const start = performance.now()
  const progress = { attempts: 0 }
  const seconds = () => Number(((performance.now() - start) / 1000).toFixed(2))
  let folder: string | undefined
  try {
    folder = await mkdtemp(join(environment.scratch, 'job-'))
    const outcome = await attempt(job, environment, folder, progress)
    return { ...outcome, seconds: seconds(), ...progress }
  } catch (error) {
    // The input cannot be read, or the output cannot be written, even after retries.
    return { ...machineFailure(error), seconds: seconds(), ...progress }
  } finally {
    // The folder may contain partial files of a killed process.
    if (folder !== undefined)
      await rm(folder, { recursive: true, force: true, maxRetries: 5 }).catch(() => {})
  }
}

/**
 * Returns the outcome for an error outside the job's process, e.g. if an input cannot be downloaded. The job may
 * succeed later.
 */
export function machineFailure(
  error: unknown,
): Required<Pick<Outcome, 'status' | 'kind' | 'reason' | 'warnings'>> {
  const reason = error instanceof Error ? error.message : String(error)
  return { status: 'failed', kind: 'machine', reason, warnings: [] }
}

async function attempt(
  job: Job,
  { pool, limits }: JobEnvironment,
  folder: string,
  progress: { attempts: number },
): Promise<Omit<Outcome, 'seconds' | 'attempts'>> {
  const command: JobCommand = JOB_COMMANDS[job.command]
  const path = await withRetries(() =>
    storeOf(job.input).fetch(job.input, job.identity, command.reads, folder),
  )
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
  } while ((end.end === 'crash' || end.end === 'memory') && progress.attempts < MAX_ATTEMPTS)
  if (end.end !== 'report') return { status: 'failed', ...limitFailure(end, limits), warnings: [] }
  const { report } = end
  // Messages should contain the addresses that the user gave, not temporary paths.
  const withAddresses = (text: string) =>
    text.replaceAll(input, job.input).replaceAll(target ?? input, job.output ?? job.input)
  const warnings = report.warnings.map(withAddresses)
  const { memory } = report
  if (report.failure !== undefined) {
    const kind = report.isBug ? 'crash' : report.isMachine ? 'machine' : 'file'
    return { status: 'failed', reason: withAddresses(report.failure), kind, warnings, memory }
  }
  const result = command.summary(JSON.parse(report.lines.join('\n')))
  if (report.exitCode !== 0) {
    return { status: 'failed', reason: `${result.errors} errors`, kind: 'file', warnings, result, memory }
  }
  if (target === undefined) return { status: 'done', warnings, result, memory }
  const bytes = await readFile(target)
  await withRetries(() => storeOf(job.output!).put(job.output!, bytes))
  return { status: 'done', warnings, result, bytes: bytes.length, memory }
}

function limitFailure(end: Exclude<ProcessEnd, { end: 'report' }>, { memory, seconds }: ProcessLimits) {
  if (end.end === 'crash') return { kind: 'crash', reason: `the process crashed (${end.reason})` } as const
  const reason =
    end.end === 'time'
      ? `exceeded the time limit of ${seconds} s; raise --timeout`
      : `exceeded the memory limit of ${Math.round(memory / 2 ** 20)} MB; raise --memory`
  return { kind: end.end, reason } as const
}
