import { createHash } from 'node:crypto'
import { setTimeout as sleep } from 'node:timers/promises'
import type { Queue, Job as QueuedJob } from 'bullmq'
import { firstLine } from 'furrow-files'
import type { Job, Outcome } from '../jobs/job.ts'
import { parseOutcome } from '../jobs/records.ts'
import type { Engine } from '../perform.ts'
import { patiently } from '../places/passing.ts'
import { placeOf } from '../places/places.ts'
import { bullmq, connectRedis, queueName } from './redis.ts'

const WHO = 'furrow batch'

/** Jobs that are looked up, or added, at once. */
const CHUNK = 500

/** Milliseconds without an outcome after which the queue is asked about every job. */
const QUIET = 60_000

/** Seconds for which the queue keeps what has ended: the batch may be started again meanwhile, and still find it. */
const KEPT = 7 * 24 * 3600

/** The id of a job in the queue: another batch may want the same with another output. */
function idOf({ key, output = '' }: Job): string {
  return `${key}-${createHash('sha256').update(output).digest('hex').slice(0, 8)}`
}

/**
 * Hands jobs to workers by way of Redis (BullMQ). Workers tell what came of a job through the queue, which outlives this process:
 * started again, it finds what was done without it. If Redis itself forgot jobs, they are added again.
 */
export function redisEngine(url: string, version: string): Engine {
  return async (jobs, onOutcome) => {
    const { Queue, QueueEvents } = await bullmq()
    let lost = false
    const connection = await connectRedis(url, WHO, () => {
      lost = true
    })
    const queue = new Queue(queueName(version), { connection })
    // From the newest event on: by default those between connecting and the first read would be missed.
    const [newest] = await connection.xrevrange(queue.keys.events, '+', '-', 'COUNT', 1)
    const lastEventId = newest?.[0] ?? '0-0'
    const events = new QueueEvents(queueName(version), { connection, lastEventId })
    // The connection's own listener has told it.
    queue.on('error', () => {})
    events.on('error', () => {})
    const waiting = new Map(jobs.map((job) => [idOf(job), job]))
    const failures: unknown[] = []
    let heard = Date.now()

    const settle = async (id: string, outcome: Outcome) => {
      const job = waiting.get(id)
      if (!job || !waiting.delete(id)) return
      heard = Date.now()
      await onOutcome(job, outcome).catch((error) => failures.push(error))
    }
    const lookUp = async (id: string) => {
      const found = waiting.has(id) ? await jobAt(queue, id) : undefined
      const outcome = found && (await outcomeOf(found))
      if (outcome) await settle(id, outcome)
    }
    const listen = ({ jobId }: { jobId: string }) => {
      lookUp(jobId).catch((error) => failures.push(error))
    }
    events.on('completed', listen).on('failed', listen)
    try {
      await events.waitUntilReady()
      await enqueue(queue, [...waiting], settle, true)
      while (waiting.size > 0 && failures.length === 0) {
        await sleep(100)
        if (!lost && Date.now() - heard < QUIET) continue
        lost = false
        heard = Date.now()
        await enqueue(queue, [...waiting], settle, false)
      }
      if (failures.length > 0) throw failures[0]
    } finally {
      await Promise.allSettled([events.close(), queue.close()])
      connection.disconnect()
    }
  }
}

/**
 * Adds the jobs that the queue does not have, and settles those that have ended.
 *
 * @param isFirst whether what has ended may be of an earlier batch: then it counts only where its output is still there.
 */
async function enqueue(
  queue: Queue,
  jobs: readonly [id: string, job: Job][],
  settle: (id: string, outcome: Outcome) => Promise<void>,
  isFirst: boolean,
): Promise<void> {
  for (let at = 0; at < jobs.length; at += CHUNK) {
    const chunk = jobs.slice(at, at + CHUNK)
    const missing = await Promise.all(
      chunk.map(async ([id, job]) => {
        const found = await jobAt(queue, id)
        if (!found) return true
        const outcome = await outcomeOf(found)
        if (!outcome) return false
        if (isFirst && !(await stillCounts(job, outcome))) {
          await found.remove()
          return true
        }
        await settle(id, outcome)
        return false
      }),
    )
    const options = { removeOnComplete: { age: KEPT }, removeOnFail: { age: KEPT } }
    const added = chunk.filter((_, i) => missing[i])
    await queue.addBulk(
      added.map(([jobId, job]) => ({ name: job.command, data: job, opts: { jobId, ...options } })),
    )
  }
}

/** What came of a job; undefined where it has not ended. */
async function outcomeOf(job: QueuedJob): Promise<Outcome | undefined> {
  const state = await job.getState()
  if (state === 'completed') return reported(job)
  if (state !== 'failed') return undefined
  // Workers report failures as outcomes: this one was with several that ended.
  const reason = `its workers ended before it (${job.failedReason})`
  return { status: 'failed', kind: 'crash', reason, warnings: [], seconds: 0, attempts: job.attemptsStarted }
}

/** Outcome that a worker reported. Anyone who can write to Redis may have put anything there. */
function reported({ returnvalue, attemptsStarted }: QueuedJob): Outcome {
  try {
    return parseOutcome(returnvalue, 'a worker')
  } catch (error) {
    const reason = `its result in Redis cannot be used (${firstLine(error)})`
    return { status: 'failed', kind: 'crash', reason, warnings: [], seconds: 0, attempts: attemptsStarted }
  }
}

/** A job of the queue, if it is there. One whose data is no JSON is removed, to be added again. */
async function jobAt(queue: Queue, id: string): Promise<QueuedJob | undefined> {
  try {
    return await queue.getJob(id)
  } catch (error) {
    if (!(error instanceof SyntaxError)) throw error
    await queue.remove(id)
    return undefined
  }
}

async function stillCounts({ output }: Job, { status, kind, bytes }: Outcome): Promise<boolean> {
  if (status === 'failed') return kind === 'file'
  return output === undefined || (await patiently(() => placeOf(output).sizeOf(output))) === bytes
}
