import { type JobEnvironment, runJob } from './jobs/run-job.ts'
import { runConcurrently } from './run-concurrently.ts'
import type { Engine } from './run-tasks.ts'

/** Creates an engine that runs jobs on this machine, at most `concurrency` at a time. */
export function localEngine(environment: JobEnvironment, concurrency: number): Engine {
  return (jobs, onOutcome) =>
    runConcurrently(jobs, concurrency, async (job) => onOutcome(job, await runJob(job, environment)))
}
