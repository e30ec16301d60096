import type { Job, Outcome } from './jobs/job.ts'
import { machineFailure } from './jobs/run-job.ts'
import type { Task } from './plan.ts'
import type { ResultLine } from './results.ts'
import { withRetries } from './stores/retries.ts'
import { storeOf } from './stores/store-of.ts'

/** Runs jobs in any order. Calls `onOutcome` when a job has ended. */
export type Engine = (
  jobs: readonly Job[],
  onOutcome: (job: Job, outcome: Outcome) => Promise<void>,
) => Promise<void>

/** Runs all tasks. When a task ends, calls `add` with one result per input. */
export async function runTasks(
  tasks: readonly Task[],
  engine: Engine,
  add: (lines: ResultLine[]) => void,
): Promise<void> {
  const byKey = new Map(tasks.map((task) => [task.job.key, task]))
  await engine(
    tasks.map(({ job }) => job),
    async (job, outcome) => {
      const { entries } = byKey.get(job.key)!
      const { key, command } = job
      const lines: ResultLine[] = []
      for (const [i, entry] of entries.entries()) {
        const own = i === 0 ? outcome : { ...(await copyFor(job, entry.output, outcome)), sameAs: job.input }
        lines.push({ key, command, ...entry, ...own })
      }
      add(lines)
    },
  )
}

/** Copies the output of a job for another input with the same content. */
async function copyFor(job: Job, output: string | undefined, outcome: Outcome): Promise<Outcome> {
  if (output === undefined || job.output === undefined || outcome.status === 'failed') return outcome
  try {
    const bytes = await withRetries(() => storeOf(job.output!).read(job.output!))
    await withRetries(() => storeOf(output).put(output, bytes))
    return outcome
  } catch (error) {
    return { ...outcome, ...machineFailure(error) }
  }
}
