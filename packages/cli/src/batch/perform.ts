import type { Job, Outcome } from './jobs/job.ts'
import { machineFailure } from './jobs/run-job.ts'
import { patiently } from './places/passing.ts'
import { placeOf } from './places/places.ts'
import type { Task } from './plan.ts'
import type { ResultLine } from './results.ts'

/** Does jobs, in whatever order, and tells what came of each. */
export type Engine = (
  jobs: readonly Job[],
  onOutcome: (job: Job, outcome: Outcome) => Promise<void>,
) => Promise<void>

/** Does all tasks; `add` gets the lines of each as it ends. */
export async function performTasks(
  tasks: readonly Task[],
  engine: Engine,
  add: (lines: ResultLine[]) => void,
): Promise<void> {
  const byKey = new Map(tasks.map((task) => [task.job.key, task]))
  await engine(
    tasks.map(({ job }) => job),
    async (job, outcome) => {
      const { places } = byKey.get(job.key)!
      const { key, command } = job
      const lines: ResultLine[] = []
      for (const [i, place] of places.entries()) {
        const own = i === 0 ? outcome : { ...(await copyFor(job, place.output, outcome)), sameAs: job.input }
        lines.push({ key, command, ...place, ...own })
      }
      add(lines)
    },
  )
}

/** Copies the output of a job for another input that is the same. */
async function copyFor(job: Job, output: string | undefined, outcome: Outcome): Promise<Outcome> {
  if (output === undefined || job.output === undefined || outcome.status === 'failed') return outcome
  try {
    const bytes = await patiently(() => placeOf(job.output!).read(job.output!))
    await patiently(() => placeOf(output).put(output, bytes))
    return outcome
  } catch (error) {
    return { ...outcome, ...machineFailure(error) }
  }
}
