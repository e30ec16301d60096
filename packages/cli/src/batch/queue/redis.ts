import { FurrowError } from 'furrow'
import type { Redis } from 'ioredis'
import { warn } from '../../print.ts'
import { optionalPackage } from '../optional-package.ts'

const PACKAGES = 'bullmq ioredis'

/** Loads BullMQ, which keeps the jobs in Redis. */
export const bullmq = () => optionalPackage(() => import('bullmq'), PACKAGES, '--redis')

/** Longest pause between two attempts to connect, in milliseconds. */
const LONGEST_PAUSE = 2000

/**
 * The queue of one version: what a job gives follows from the version, so that workers of another one must not take it. Redis'
 * databases, as in `redis://host/1`, keep batches apart that are not to share workers.
 */
export const queueName = (version: string) => `furrow-${version}`

/**
 * Connects to Redis and stays so: a connection that is lost, or not there yet, is tried again until it is back, and commands wait.
 *
 * @throws FurrowError where the address is none of Redis.
 */
export async function connectRedis(url: string, who: string, onBack: () => void = () => {}): Promise<Redis> {
  const { Redis } = await optionalPackage(() => import('ioredis'), PACKAGES, '--redis')
  if (!/^rediss?:\/\/./i.test(url)) {
    throw new FurrowError({
      code: 'usage',
      who,
      problem: 'not an address of Redis',
      value: url,
      limit: 'redis://host:6379/0, rediss://user:password@host',
      remedy: 'correct --redis',
    })
  }
  const redis = new Redis(url, {
    // As BullMQ asks: commands wait for the connection instead of failing.
    maxRetriesPerRequest: null,
    retryStrategy: (times) => Math.min(100 * times, LONGEST_PAUSE),
  })
  const { host } = new URL(url)
  let isLost = false
  redis.on('error', ({ message }) => {
    if (!isLost) warn(`${who}: no connection to Redis at ${host} (${message}); trying until there is one`)
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
