// Tests `furrow batch` with S3 addresses on a small fake server. `bench/batch` uses a real S3 server.

import { createHash } from 'node:crypto'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { createServer, type Server } from 'node:http'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { buffer } from 'node:stream/consumers'
import { afterAll, beforeAll, expect, it } from 'vitest'
import { runFurrow } from '../pages/run-furrow.ts'
import { isCompleteGlb, makeFaces } from './faces.ts'

const folder = mkdtempSync(join(tmpdir(), 'furrow-s3-'))
/** Stored objects by `bucket/key`. */
const objects = new Map<string, Buffer>()
const puts: string[] = []
let server: Server
/** Number of uploads that the server still refuses with status 503. */
let refusals = 0

const tagOf = (bytes: Buffer) => `"${createHash('md5').update(bytes).digest('hex')}"`

beforeAll(async () => {
  const faces = await makeFaces(2)
  for (const [i, bytes] of faces.entries()) objects.set(`avatars/in/${i}.glb`, Buffer.from(bytes))
  objects.set('avatars/in/copy.glb', Buffer.from(faces[0]))
  objects.set('avatars/in/notes.txt', Buffer.from('text'))
  server = createServer(async (request, response) => {
    const url = new URL(request.url!, 'http://store')
    const path = decodeURIComponent(url.pathname.slice(1))
    if (request.method === 'PUT') {
      const bytes = await buffer(request)
      if (refusals-- > 0) return void response.writeHead(503).end()
      objects.set(path, bytes)
      puts.push(path)
      return void response.writeHead(200, { etag: tagOf(bytes) }).end()
    }
    if (url.searchParams.has('list-type'))
      return void response.end(listing(path, url.searchParams.get('prefix')!))
    const bytes = objects.get(path)
    if (!bytes) return void response.writeHead(404).end()
    response.writeHead(200, { etag: tagOf(bytes), 'content-length': bytes.length })
    response.end(request.method === 'HEAD' ? undefined : bytes)
  })
  await new Promise<void>((ready) => server.listen(0, '127.0.0.1', ready))
})
afterAll(() => {
  server.close()
  rmSync(folder, { recursive: true })
})

function listing(bucket: string, prefix: string): string {
  const found = [...objects].filter(([path]) => path.startsWith(`${bucket.replace(/\/$/, '')}/${prefix}`))
  const items = found.map(
    ([path, bytes]) =>
      `<Contents><Key>${path.slice(path.indexOf('/') + 1)}</Key><ETag>${tagOf(bytes)}</ETag><Size>${bytes.length}</Size></Contents>`,
  )
  return `<ListBucketResult><IsTruncated>false</IsTruncated>${items.join('')}</ListBucketResult>`
}

const batch = (...words: string[]) => {
  const env = {
    AWS_ENDPOINT_URL: `http://127.0.0.1:${(server.address() as AddressInfo).port}`,
    AWS_ACCESS_KEY_ID: 'key',
    AWS_SECRET_ACCESS_KEY: 'secret',
  }
  return runFurrow(folder, env, 'batch', ...words, '--results', 'results', '--thumbnails', '0', '--json')
}
const ALL = ['s3://avatars/in/', '-o', 's3://avatars/out', '--size', '512']

it('reads all faces under an address and writes each output once', async () => {
  // The AWS SDK retries a request three times, so four refusals also test the retry of the batch.
  refusals = 4
  const { code, stdout, stderr } = await batch(...ALL)
  expect(code, stderr).toBe(0)
  expect(JSON.parse(stdout)).toMatchObject({ inputs: 3, done: 3, shared: 1 })
  expect(puts.sort()).toEqual(['avatars/out/0.glb', 'avatars/out/1.glb', 'avatars/out/copy.glb'])
  for (const name of puts) expect(isCompleteGlb(objects.get(name)!)).toBe(true)
})

it('resumes a stopped batch', async () => {
  objects.delete('avatars/out/1.glb')
  puts.length = 0
  const { stdout } = await batch(...ALL)
  expect(JSON.parse(stdout)).toMatchObject({ done: 3, kept: 2 })
  expect(puts).toEqual(['avatars/out/1.glb'])
})

it('reports missing buckets and keys', async () => {
  const { code } = await batch('s3://avatars/in/none.glb', '-o', 's3://avatars/out')
  expect(code).toBe(1)
  const lines = readFileSync(join(folder, 'results/results.jsonl'), 'utf8').trimEnd().split('\n')
  expect(JSON.parse(lines.at(-1)!).reason).toMatch(
    /cannot read s3:\/\/avatars\/in\/none\.glb \(it does not exist\)/,
  )
  const empty = await batch('s3://avatars/nothing/', '-o', 's3://avatars/out')
  expect(empty.stderr).toMatch(/no input at s3:\/\/avatars\/nothing\/ \(no \.glb or \.vrm files below it\)/)
})
