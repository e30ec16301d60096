import { type JobEnvironment, runJob } from './jobs/run-job.ts'
import { runConcurrently } from './run-concurrently.ts'
import type { Engine } from './run-tasks.ts'

/** Runs jobs on this machine, `concurrency` at a time. */
export function localEngine(environment: JobEnvironment, concurrency: number): Engine {
  return (jobs, onOutcome) =>
    runConcurrently(jobs, concurrency, async (job) => onOutcome(job, await runJob(job, environment)))
}
