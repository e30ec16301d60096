import { createHash } from 'node:crypto'
import { setTimeout as sleep } from 'node:timers/promises'
import type { Queue, Job as QueuedJob } from 'bullmq'
import { firstLine } from 'furrow-files'
import type { Job, Outcome } from '../jobs/job.ts'
import { parseOutcome } from '../jobs/records.ts'
import type { Engine } from '../run-tasks.ts'
import { withRetries } from '../stores/retries.ts'
import { storeOf } from '../stores/store-of.ts'
import { bullmq, connectRedis, queueName } from './redis.ts'

const WHO = 'furrow batch'

/** Number of jobs that are looked up or added in one step. */
const CHUNK = 500

/** The queue is polled if no job has ended for this time, milliseconds. */
const POLL_AFTER = 60_000

/**
 * The queue keeps ended jobs for this time, seconds. If a batch is run again within this time, it finds their outcomes.
 */
const RETENTION = 7 * 24 * 3600

/**
 * Returns the id of a job in the queue. The id depends on the output path, because two batches may write the same
 * result to different files.
 */
function idOf({ key, output = '' }: Job): string {
  return `${key}-${createHash('sha256').update(output).digest('hex').slice(0, 8)}`
}

/**
 * Creates an engine that sends jobs to workers through Redis (BullMQ). Outcomes stay in Redis when this process ends,
 * so a batch that is run again finds them. The engine adds jobs again if Redis loses them.
 */
export function redisEngine(url: string, version: string): Engine {
  return async (jobs, onOutcome) => {
    const { Queue, QueueEvents } = await bullmq()
    let lost = false
    const connection = await connectRedis(url, WHO, () => {
      lost = true
    })
    const queue = new Queue(queueName(version), { connection })
    // Reads all events from now on. By default, BullMQ would miss events between the connection and its first read.
    const [newest] = await connection.xrevrange(queue.keys.events, '+', '-', 'COUNT', 1)
    const lastEventId = newest?.[0] ?? '0-0'
    const events = new QueueEvents(queueName(version), { connection, lastEventId })
    // `connectRedis` already reports errors of the connection.
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
        if (!lost && Date.now() - heard < POLL_AFTER) continue
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
 * Adds jobs that are not in the queue yet. Reports the outcomes of jobs that have ended.
 *
 * @param isFirst whether ended jobs can be from an earlier batch. Ended jobs that fail `isStillValid` are then added
 *   again.
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
        if (isFirst && !(await isStillValid(job, outcome))) {
          await found.remove()
          return true
        }
        await settle(id, outcome)
        return false
      }),
    )
    const options = { removeOnComplete: { age: RETENTION }, removeOnFail: { age: RETENTION } }
    const added = chunk.filter((_, i) => missing[i])
    await queue.addBulk(
      added.map(([jobId, job]) => ({ name: job.command, data: job, opts: { jobId, ...options } })),
    )
  }
}

/** Returns the outcome of a job, or undefined if the job has not ended. */
async function outcomeOf(job: QueuedJob): Promise<Outcome | undefined> {
  const state = await job.getState()
  if (state === 'completed') return reportedOutcome(job)
  if (state !== 'failed') return undefined
  // BullMQ marks a job as failed only if its workers disappeared too often. A job whose command fails is `completed`.
  const reason = `its workers stopped before the job was done (${job.failedReason})`
  return { status: 'failed', kind: 'crash', reason, warnings: [], seconds: 0, attempts: job.attemptsStarted }
}

/** Returns the outcome that a worker reported. Validates the outcome, because other programs can write to Redis. */
function reportedOutcome({ returnvalue, attemptsStarted }: QueuedJob): Outcome {
  try {
    return parseOutcome(returnvalue, 'a worker')
  } catch (error) {
    const reason = `its result in Redis is invalid (${firstLine(error)})`
    return { status: 'failed', kind: 'crash', reason, warnings: [], seconds: 0, attempts: attemptsStarted }
  }
}

/**
 * Returns a job of the queue, if the queue contains it. Removes a job with invalid JSON, so that it can be added again.
 */
async function jobAt(queue: Queue, id: string): Promise<QueuedJob | undefined> {
  try {
    return await queue.getJob(id)
  } catch (error) {
    if (!(error instanceof SyntaxError)) throw error
    await queue.remove(id)
    return undefined
  }
}

async function isStillValid({ output }: Job, { status, kind, bytes }: Outcome): Promise<boolean> {
  if (status === 'failed') return kind === 'file'
  return output === undefined || (await withRetries(() => storeOf(output).sizeOf(output))) === bytes
}
