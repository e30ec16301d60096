import { createCommand } from '../../command.ts'
import { print } from '../../print.ts'
import { version } from '../../version.ts'
import type { Job, Outcome } from '../jobs/job.ts'
import { parseJob } from '../jobs/records.ts'
import { machineFailure, runJob, type Workshop } from '../jobs/run-job.ts'
import { LIMIT_OPTIONS, type LimitOptions, limitsOf } from '../limits.ts'
import { ProcessPool } from '../processes/process-pool.ts'
import { bullmq, connectRedis, queueName } from '../queue/redis.ts'
import { openScratch } from '../scratch.ts'

const WHO = 'furrow worker'

/**
 * So often a job begins again because the worker that had it is gone. Its own limits end a job long before it can take a worker with
 * it, so that it is the machines that come and go.
 */
const MOST_STALLS = 20

interface Options extends LimitOptions {
  redis: string
}

/** `furrow worker`: does the jobs of `furrow batch --redis`. */
export const workerCommand = createCommand('worker')
  .description('take the jobs of furrow batch --redis, on this machine, until it is told to end')
  .requiredOption('--redis <url>', 'the Redis of the batch, e.g. redis://host:6379/0')
  .addHelpText(
    'after',
    `
Inputs and outputs are read and written by their addresses: paths must be of a disk that all machines have at the same place.
SIGTERM or Ctrl-C: it ends once the jobs that it has begun are done; a second one ends it at once, and others do these jobs again.

Examples:
  $ furrow worker --redis redis://10.0.0.5:6379
  $ furrow worker --redis redis://10.0.0.5:6379 --jobs 4 --memory 2048`,
  )
  .action(work)
for (const option of LIMIT_OPTIONS) workerCommand.addOption(option)

async function work({ redis: url, ...options }: Options): Promise<void> {
  const { Worker } = await bullmq()
  const { lanes, limits } = limitsOf(options)
  const connection = await connectRedis(url, WHO)
  const pool = new ProcessPool(limits)
  const scratch = openScratch({ endsBySignal: false })
  process.once('exit', () => {
    pool.close()
    scratch.remove()
  })
  // The jobs themselves run in other processes: this one has nothing to do but to renew their locks.
  const worker = new Worker<unknown, Outcome>(
    queueName(version),
    ({ data }) => perform(data, { pool, limits, scratch: scratch.path }),
    {
      connection,
      concurrency: lanes,
      maxStalledCount: MOST_STALLS,
    },
  )
  worker.on('error', () => {})
  worker.on('completed', ({ data }, { status, reason, seconds }) => {
    const { input = 'a job' } = Object(data)
    print(`${input}: ${status === 'done' ? `done, ${seconds} s` : reason}`)
  })
  print(`${WHO}: ready for ${lanes} jobs at a time`)
  await signalled()
  print(`${WHO}: ending, once the jobs that it has begun are done`)
  await worker.close()
  connection.disconnect()
  process.exit()
}

/** Does a job of the queue. Whoever can write to Redis may have put anything there. */
async function perform(data: unknown, workshop: Workshop): Promise<Outcome> {
  let job: Job
  try {
    job = parseJob(data, WHO)
  } catch (error) {
    return { ...machineFailure(error), kind: 'file', seconds: 0, attempts: 0 }
  }
  return runJob(job, workshop)
}

/** Waits for the first signal that asks for the end; the second one ends the process. */
function signalled(): Promise<void> {
  const signals = ['SIGINT', 'SIGTERM'] as const
  return new Promise((resolve) => {
    const listen = () => {
      for (const signal of signals) process.off(signal, listen)
      resolve()
    }
    for (const signal of signals) process.on(signal, listen)
  })
}
