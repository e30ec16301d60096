import { FurrowError } from 'furrow'
import type { Redis } from 'ioredis'
import { warn } from '../../print.ts'
import { optionalPackage } from '../optional-package.ts'

const PACKAGES = 'bullmq ioredis'

/** Loads BullMQ, the job queue on Redis. */
export const bullmq = () => optionalPackage(() => import('bullmq'), PACKAGES, '--redis')

/** Maximum delay between attempts to connect, milliseconds. */
const MAX_RETRY_DELAY = 2000

/**
 * Returns the name of the queue for a version of this package. Results depend on the version, so a worker must not run
 * jobs of another version. To separate batches of one version, use different Redis databases, e.g. `redis://host/1`.
 */
export const queueName = (version: string) => `furrow-${version}`

/**
 * Connects to Redis, and reconnects whenever the connection is lost. Commands wait for the connection.
 *
 * @param onBack called after each reconnection.
 * @throws FurrowError if the URL is not a Redis URL.
 */
export async function connectRedis(url: string, who: string, onBack: () => void = () => {}): Promise<Redis> {
  const { Redis } = await optionalPackage(() => import('ioredis'), PACKAGES, '--redis')
  if (!/^rediss?:\/\/./i.test(url)) {
    throw new FurrowError({
      code: 'usage',
      who,
      problem: 'invalid Redis URL',
      value: url,
      limit: 'redis://host:6379/0, rediss://user:password@host',
      remedy: 'correct --redis',
    })
  }
  const redis = new Redis(url, {
    // BullMQ requires null, so that commands wait for the connection and do not fail.
    maxRetriesPerRequest: null,
    retryStrategy: (times) => Math.min(100 * times, MAX_RETRY_DELAY),
  })
  const { host } = new URL(url)
  let isLost = false
  redis.on('error', ({ message }) => {
    if (!isLost) warn(`${who}: no connection to Redis at ${host} (${message}); retrying`)
    isLost = true
  })
  redis.on('ready', () => {
    if (!isLost) return
    isLost = false
    warn(`${who}: connected to Redis at ${host}`)
    onBack()
  })
  return redis
}
