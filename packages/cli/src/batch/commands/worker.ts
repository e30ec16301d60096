import { createCommand } from '../../command.ts'
import { print } from '../../print.ts'
import { version } from '../../version.ts'
import type { Job, Outcome } from '../jobs/job.ts'
import { parseJob } from '../jobs/records.ts'
import { type JobEnvironment, machineFailure, runJob } from '../jobs/run-job.ts'
import { LIMIT_OPTIONS, type LimitOptions, limitsOf } from '../limits.ts'
import { ProcessPool } from '../processes/process-pool.ts'
import { bullmq, connectRedis, queueName } from '../queue/redis.ts'
import { openScratch } from '../scratch.ts'

const WHO = 'furrow worker'

/**
 * Maximum number of restarts of a job whose worker disappeared. The number is high: a worker usually disappears because
 * its machine is switched off, and not because of its job. Limits of memory and time end a job before it could crash a
 * worker.
 */
const MAX_STALLS = 20

interface Options extends LimitOptions {
  redis: string
}

export const workerCommand = createCommand('worker')
  .description('run the jobs that furrow batch --redis queues')
  .requiredOption('--redis <url>', 'Redis server, e.g. redis://host:6379/0')
  .addHelpText(
    'after',
    `
Local paths must be on a disk that all machines mount at the same path. Ctrl-C
or SIGTERM stops the worker after its running jobs. A second signal stops it at
once, and other workers restart its jobs.

Example:
  $ furrow worker --redis redis://10.0.0.5:6379 --jobs 4 --memory 2048`,
  )
  .action(work)
for (const option of LIMIT_OPTIONS) workerCommand.addOption(option)

async function work({ redis: url, ...options }: Options): Promise<void> {
  const { Worker } = await bullmq()
  const { concurrency, limits } = limitsOf(options)
  const connection = await connectRedis(url, WHO)
  const pool = new ProcessPool(limits)
  const scratch = openScratch({ endsBySignal: false })
  process.once('exit', () => {
    pool.close()
    scratch.remove()
  })
  // BullMQ renews the lock of a running job on this process's event loop. Jobs run in child processes, so that they do
  // not block the loop.
  const worker = new Worker<unknown, Outcome>(
    queueName(version),
    ({ data }) => runQueuedJob(data, { pool, limits, scratch: scratch.path }),
    {
      connection,
      concurrency,
      maxStalledCount: MAX_STALLS,
    },
  )
  worker.on('error', () => {})
  worker.on('completed', ({ data }, { status, reason, seconds }) => {
    const { input = 'a job' } = Object(data)
    print(`${input}: ${status === 'done' ? `done, ${seconds} s` : reason}`)
  })
  print(`${WHO}: ready for ${concurrency} parallel jobs`)
  await firstSignal()
  print(`${WHO}: stopping after the running jobs`)
  await worker.close()
  connection.disconnect()
  process.exit()
}

/** Runs a job from the queue. Validates the job, because other programs can write to Redis. */
async function runQueuedJob(data: unknown, environment: JobEnvironment): Promise<Outcome> {
  let job: Job
  try {
    job = parseJob(data, WHO)
  } catch (error) {
    return { ...machineFailure(error), kind: 'file', seconds: 0, attempts: 0 }
  }
  return runJob(job, environment)
}

/** Waits for the first SIGINT or SIGTERM. A second signal ends the process. */
function firstSignal(): Promise<void> {
  const signals = ['SIGINT', 'SIGTERM'] as const
  return new Promise((resolve) => {
    const listen = () => {
      for (const signal of signals) process.off(signal, listen)
      resolve()
    }
    for (const signal of signals) process.on(signal, listen)
  })
}
