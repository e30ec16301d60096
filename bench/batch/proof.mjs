// Tests the reliability of `furrow batch --redis` with an S3 store and two workers. During the test, it kills and restarts the workers, Redis and
// the batch. See README.md.

import { spawn } from 'node:child_process'
import { readFileSync, writeFileSync } from 'node:fs'
import { mkdir, readdir, readFile, rm } from 'node:fs/promises'
import { join, resolve } from 'node:path'
import { setTimeout as sleep } from 'node:timers/promises'
import { fileURLToPath } from 'node:url'
import { parseArgs } from 'node:util'
import {
  CreateBucketCommand,
  GetObjectCommand,
  ListObjectsV2Command,
  PutObjectCommand,
  paginateListObjectsV2,
  S3Client,
} from '@aws-sdk/client-s3'
import { median } from '../median.mjs'

const FURROW = fileURLToPath(new URL('../../packages/cli/bin/furrow.js', import.meta.url))

const { values } = parseArgs({
  options: {
    avatars: { type: 'string' },
    count: { type: 'string', default: '1000' },
    gateway: { type: 'string', default: 'versitygw' },
    folder: { type: 'string', default: 'furrow-proof' },
    kills: { type: 'string', default: '20' },
    'redis-kills': { type: 'string', default: '2' },
    'batch-kills': { type: 'string', default: '1' },
    size: { type: 'string', default: '512' },
    port: { type: 'string', default: '7079' },
  },
})
const count = Number(values.count)
const folder = resolve(values.folder)
const port = Number(values.port)
const redisUrl = `redis://127.0.0.1:${port}`
const KEY = 'furrow-proof-key'
const env = {
  ...process.env,
  AWS_ACCESS_KEY_ID: KEY,
  AWS_SECRET_ACCESS_KEY: KEY,
  AWS_ENDPOINT_URL: `http://127.0.0.1:${port + 1}`,
  AWS_REGION: 'us-east-1',
}
const client = new S3Client({
  endpoint: env.AWS_ENDPOINT_URL,
  region: env.AWS_REGION,
  forcePathStyle: true,
  credentials: { accessKeyId: KEY, secretAccessKey: KEY },
})

const started = new Set()
process.on('exit', () => {
  for (const child of started) child.kill('SIGKILL')
})
const logs = []

function start(program, words, onLine = () => {}) {
  const child = spawn(program, words, { env, stdio: ['ignore', 'pipe', 'pipe'], cwd: folder })
  started.add(child)
  for (const stream of [child.stdout, child.stderr]) {
    stream.on('data', (text) => {
      for (const line of String(text).split('\n').filter(Boolean)) {
        logs.push(`${child.pid} ${line}`)
        onLine(line)
      }
    })
  }
  child.ended = new Promise((done) => child.once('close', (code) => done(code)))
  child.ended.then(() => started.delete(child))
  return child
}

const startRedis = () =>
  start('redis-server', ['--port', String(port), '--dir', folder, '--appendonly', 'yes', '--save', ''])

/** Number of times that workers reported an input as done, by the input's address. */
const doneTimes = new Map()
function startWorker() {
  return start(process.execPath, [FURROW, 'worker', '--redis', redisUrl, '--jobs', '1'], (line) => {
    const [, input] = /^(s3:\S+): done/.exec(line) ?? []
    if (input) doneTimes.set(input, (doneTimes.get(input) ?? 0) + 1)
  })
}

const startBatch = () =>
  start(process.execPath, [
    ...[FURROW, 'batch', 's3://avatars/', '-o', 's3://wrinkled', '--redis', redisUrl, '--size', values.size],
    ...['--results', 'results', '--thumbnails', '0', '--json'],
  ])

async function listAll(Bucket) {
  const found = []
  for await (const { Contents = [] } of paginateListObjectsV2({ client }, { Bucket })) found.push(...Contents)
  return found
}

/** Returns whether an object of the store is a binary glTF file whose length equals the length in its header. */
async function isComplete(Key) {
  const { Body } = await client.send(new GetObjectCommand({ Bucket: 'wrinkled', Key }))
  const bytes = await Body.transformToByteArray()
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length)
  return (
    bytes.length > 12 && view.getUint32(0, true) === 0x46546c67 && view.getUint32(8, true) === bytes.length
  )
}

function readLines() {
  try {
    return readFileSync(join(folder, 'results/results.jsonl'), 'utf8').trimEnd().split('\n').filter(Boolean)
  } catch {
    return []
  }
}

await rm(folder, { recursive: true, force: true })
await mkdir(join(folder, 'store'), { recursive: true })
let redis = startRedis()
start(values.gateway, [
  '--access',
  KEY,
  '--secret',
  KEY,
  '--port',
  `:${port + 1}`,
  'posix',
  join(folder, 'store'),
])
await sleep(2000)
for (const Bucket of ['avatars', 'wrinkled']) await client.send(new CreateBucketCommand({ Bucket }))
const files = (await readdir(values.avatars)).sort().slice(0, count)
for (const Key of files) {
  const Body = await readFile(join(values.avatars, Key))
  await client.send(new PutObjectCommand({ Bucket: 'avatars', Key, Body }))
}
console.info(`${files.length} avatars in the store`)

const begin = performance.now()
const workers = [startWorker(), startWorker()]
let batch = startBatch()
const kills = Number(values.kills)
const redisKills = Number(values['redis-kills'])
const batchKills = Number(values['batch-kills'])
const killed = { workers: 0, redis: 0, batch: 0 }
const seen = new Map()
const partial = []
let counts
let isOver = false
const watchEnd = (child) =>
  child.ended.then((code) => {
    if (child === batch) {
      isOver = true
      counts = { code, line: logs.findLast((line) => line.startsWith(`${child.pid} {`)) }
    }
  })
watchEnd(batch)

// Spreads the kills evenly over the expected number of results. Meanwhile, checks that every new file in the store is complete.
const due = (times, total) => Math.floor(((times + 0.5) / total) * count)
while (!isOver) {
  await sleep(500)
  const done = readLines().length
  if (killed.workers < kills && done >= due(killed.workers, kills)) {
    const at = killed.workers++ % workers.length
    workers[at].kill('SIGKILL')
    workers[at] = startWorker()
    console.info(`${done} results: worker ${at + 1} killed (${killed.workers})`)
  }
  if (killed.redis < redisKills && done >= due(killed.redis, redisKills)) {
    killed.redis++
    redis.kill('SIGKILL')
    await redis.ended
    await sleep(3000)
    redis = startRedis()
    console.info(`${done} results: Redis killed and restarted (${killed.redis})`)
  }
  if (killed.batch < batchKills && done >= due(killed.batch, batchKills) + 5) {
    killed.batch++
    const old = batch
    batch = startBatch()
    old.kill('SIGKILL')
    watchEnd(batch)
    console.info(`${done} results: batch killed and restarted (${killed.batch})`)
  }
  const { Contents = [] } = await client.send(new ListObjectsV2Command({ Bucket: 'wrinkled' }))
  for (const { Key, ETag } of Contents) {
    if (seen.get(Key) === ETag) continue
    if (!(await isComplete(Key))) partial.push(Key)
    seen.set(Key, ETag)
  }
}
const seconds = (performance.now() - begin) / 1000
const memory = workers.map(({ pid }) =>
  Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))[1]),
)

const outputs = await listAll('wrinkled')
const names = new Set(outputs.map(({ Key }) => Key))
const lines = readLines().map((line) => JSON.parse(line))
const ofDone = lines.filter(({ status }) => status === 'done')
for (const { Key } of outputs) if (!(await isComplete(Key))) partial.push(Key)
const check = start(process.execPath, [
  FURROW,
  'batch',
  's3://wrinkled/',
  '--command',
  'validate',
  '--results',
  'checked',
  '--json',
])
const valid = { code: await check.ended, line: logs.findLast((line) => line.startsWith(`${check.pid} {`)) }

const megabytes = (list) => Math.round(median(list.map((bytes) => bytes / 2 ** 20)))
const memories = ofDone.map((line) => line.memory).filter(Boolean)
const tenth = Math.ceil(memories.length / 10)
const report = {
  avatars: files.length,
  killed,
  seconds: Math.round(seconds),
  batch: counts,
  outputs: outputs.length,
  missing: files.filter((name) => !names.has(name)),
  others: [...names].filter((name) => !files.includes(name)),
  partial,
  resultLines: lines.length,
  inputsWithResult: new Set(lines.map(({ input }) => input)).size,
  doneTwice: [...doneTimes.values()].filter((times) => times > 1).length,
  validated: valid,
  secondsPerJob: median(ofDone.map((line) => line.seconds)),
  megabytesOfJobs: { first: megabytes(memories.slice(0, tenth)), last: megabytes(memories.slice(-tenth)) },
  megabytesOfWorkers: memory.map((kB) => Math.round(kB / 1024)),
}
writeFileSync(join(folder, 'report.json'), `${JSON.stringify(report, null, 2)}\n`)
writeFileSync(join(folder, 'log.txt'), logs.join('\n'))
console.info(JSON.stringify(report, null, 2))
process.exit()
