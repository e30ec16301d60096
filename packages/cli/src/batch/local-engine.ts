import { runJob, type Workshop } from './jobs/run-job.ts'
import { inLanes } from './lanes.ts'
import type { Engine } from './perform.ts'

/** Does jobs on this machine, `lanes` at a time. */
export function localEngine(workshop: Workshop, lanes: number): Engine {
  return (jobs, onOutcome) => inLanes(jobs, lanes, async (job) => onOutcome(job, await runJob(job, workshop)))
}
