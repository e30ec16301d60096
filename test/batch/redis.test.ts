// Tests `furrow batch --redis` and `furrow worker` with a real Redis, while workers, Redis and the batch are killed.

import { type ChildProcess, spawn } from 'node:child_process'
import { readdirSync, readFileSync, statSync } from 'node:fs'
import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises'
import { createServer } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { setTimeout as sleep } from 'node:timers/promises'
import { Queue, Worker } from 'bullmq'
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { queueName } from '../../packages/cli/src/batch/queue/redis.ts'
import type { ResultLine } from '../../packages/cli/src/batch/results.ts'
import { version } from '../../packages/cli/src/version.ts'
import { runFurrow, startFurrow } from '../pages/run-furrow.ts'
import { isCompleteGlb, makeFaces } from './faces.ts'

const COUNT = 8

let folder: string
let port: number
let redis: ChildProcess
const started = new Set<ChildProcess>()

beforeEach(async () => {
  folder = await mkdtemp(join(tmpdir(), 'furrow-redis-'))
  await mkdir(join(folder, 'in'))
  const faces = await makeFaces(COUNT)
  await Promise.all(faces.map((bytes, i) => writeFile(join(folder, 'in', `${i}.glb`), bytes)))
  port = await freePort()
  redis = startRedis()
})
afterEach(async () => {
  for (const child of started) await end(child)
  await rm(folder, { recursive: true, maxRetries: 5 })
})

const url = () => `redis://127.0.0.1:${port}`

function startRedis(): ChildProcess {
  const words = ['--port', String(port), '--dir', folder, '--appendonly', 'yes', '--save', '']
  return keep(spawn('redis-server', words, { stdio: 'ignore' }))
}

const startWorker = () => keep(startFurrow(folder, {}, 'worker', '--redis', url(), '--jobs', '1'))

const WORDS = ['batch', 'in/*.glb', '-o', 'out', '--size', '512', '--thumbnails', '0', '--json']

function keep<T extends ChildProcess>(child: T): T {
  started.add(child)
  child.once('close', () => started.delete(child))
  return child
}

async function end(child: ChildProcess, signal: NodeJS.Signals = 'SIGKILL'): Promise<number | null> {
  if (child.exitCode !== null) return child.exitCode
  const closed = new Promise<number | null>((done) => child.once('close', done))
  child.kill(signal)
  return closed
}

async function freePort(): Promise<number> {
  const server = createServer()
  await new Promise<void>((ready) => server.listen(0, '127.0.0.1', ready))
  const address = server.address()
  await new Promise((closed) => server.close(closed))
  return (address as { port: number }).port
}

function results(): ResultLine[] {
  try {
    const lines = readFileSync(join(folder, 'out/results.jsonl'), 'utf8').split('\n').filter(Boolean)
    return lines.map((line) => JSON.parse(line))
  } catch {
    return []
  }
}

async function waitForResults(count: number): Promise<void> {
  while (results().length < count) await sleep(50)
}

function expectAllThere(): void {
  const names = readdirSync(join(folder, 'out')).filter((name) => name.endsWith('.glb'))
  expect(names).toHaveLength(COUNT)
  for (const name of names) expect(isCompleteGlb(readFileSync(join(folder, 'out', name)))).toBe(true)
  expect(results().every(({ status }) => status === 'done')).toBe(true)
  expect(new Set(results().map(({ input }) => input)).size).toBe(COUNT)
}

it('writes every output exactly once although workers, Redis and the batch are killed', async () => {
  const worker = startWorker()
  startWorker()
  const batch = keep(startFurrow(folder, {}, ...WORDS, '--redis', url()))
  await waitForResults(1)
  await end(worker)
  startWorker()
  await waitForResults(2)
  await end(redis)
  await sleep(1000)
  redis = startRedis()
  await waitForResults(3)
  await end(batch)
  const { code, stdout } = await runFurrow(folder, {}, ...WORDS, '--redis', url())
  expect(code).toBe(0)
  expect(JSON.parse(stdout)).toMatchObject({ inputs: COUNT, done: COUNT, failed: 0 })
  expectAllThere()
})

it('adds jobs again after Redis has lost them', async () => {
  const batch = keep(startFurrow(folder, {}, ...WORDS, '--redis', url()))
  const ended = new Promise((done) => batch.once('close', done))
  // The batch only queues its jobs, because no worker runs yet.
  await sleep(3000)
  await end(redis)
  await rm(join(folder, 'appendonlydir'), { recursive: true })
  redis = startRedis()
  startWorker()
  startWorker()
  expect(await ended).toBe(0)
  expectAllThere()
})

it('finishes the current job before a worker stops', async () => {
  const worker = startWorker()
  const batch = keep(startFurrow(folder, {}, ...WORDS, '--redis', url()))
  const ended = new Promise((done) => batch.once('close', done))
  await waitForResults(1)
  const stopped = end(worker, 'SIGTERM')
  expect(await stopped).toBe(0)
  // The first worker left no unfinished job, so the second can start at once.
  startWorker()
  expect(await ended).toBe(0)
  expectAllThere()
  expect(results().every(({ attempts }) => attempts === 1)).toBe(true)
})

it.each([null, {}, 'text', { status: 'done', warnings: 5 }])(
  'fails the job and ends the batch if a worker reports %j',
  async (value) => {
    const worker = new Worker(queueName(version), async () => value, { connection: { port } })
    const { code, stdout, stderr } = await runFurrow(folder, {}, ...WORDS, '--redis', url())
    await worker.close()
    expect([code, stderr]).toEqual([1, ''])
    expect(JSON.parse(stdout)).toMatchObject({ inputs: COUNT, failed: COUNT })
    for (const { reason } of results()) expect(reason).toMatch(/^its result in Redis is invalid \(a worker: /)
  },
)

it.each([null, { command: 'auto' }, { command: 'none', input: 5 }])(
  'keeps the worker running after the invalid job %j',
  async (data) => {
    const worker = startWorker()
    const ended = vi.fn()
    worker.once('close', ended)
    const queue = new Queue(queueName(version), { connection: { port } })
    await queue.add('auto', data)
    const { code } = await runFurrow(folder, {}, ...WORDS, '--redis', url())
    await queue.close()
    expect(code).toBe(0)
    expect(ended).not.toHaveBeenCalled()
    expectAllThere()
  },
)

it('leaves no files behind when a worker is killed', async () => {
  const tmp = join(folder, 'tmp')
  await mkdir(tmp)
  const worker = keep(startFurrow(folder, { TMPDIR: tmp }, 'worker', '--redis', url(), '--jobs', '1'))
  const batch = keep(startFurrow(folder, {}, ...WORDS, '--redis', url()))
  await waitForResults(1)
  const [own] = readdirSync(tmp)
  expect(statSync(join(tmp, own)).mode & 0o777).toBe(0o700)
  await end(worker)
  await end(batch)
  await expect.poll(() => readdirSync(tmp)).toEqual([])
})
