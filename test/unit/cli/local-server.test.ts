import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { type LocalServer, startLocalServer } from '../../../packages/cli/src/render/local-server.ts'
import { HOSTILE_BYTES, HOSTILE_PATHS, request, send, statusOf } from '../../hostile-requests.ts'

const folder = mkdtempSync(join(tmpdir(), 'furrow-server-'))
const SECRET = 'not to be served'
let server: LocalServer
/** Address of the server, including the secret path. */
let base: string

beforeAll(async () => {
  mkdirSync(join(folder, 'page/assets'), { recursive: true })
  writeFileSync(join(folder, 'page/index.html'), 'the page')
  writeFileSync(join(folder, 'page/assets/a.js'), 'a script')
  writeFileSync(join(folder, 'secret.txt'), SECRET)
  symlinkSync(join(folder, 'secret.txt'), join(folder, 'page/link.txt'))
  server = await startLocalServer(join(folder, 'page'))
  base = new URL(server.origin).pathname
})

afterAll(async () => {
  await server.close()
  rmSync(folder, { recursive: true })
})

async function expectAlive(): Promise<void> {
  expect(await (await fetch(server.page)).text()).toBe('the page')
}

test('the page and its files are served', async () => {
  await expectAlive()
  const script = await fetch(`${server.origin}/page/assets/a.js`)
  expect(script.headers.get('content-type')).toBe('text/javascript')
  expect(await script.text()).toBe('a script')
})

test.each(HOSTILE_PATHS.map((path) => [path.slice(0, 40), path]))('GET %s is refused', async (_, path) => {
  for (const prefix of ['', base, `${base}/page`, `${base}/file`]) {
    const response = await request(server.origin, `${prefix}${path}`)
    expect(statusOf(response), prefix).toBeGreaterThanOrEqual(400)
    expect(response).not.toContain(SECRET)
  }
  await expectAlive()
})

test.each(HOSTILE_BYTES.map((bytes, i) => [i, bytes] as const))(
  'the server continues after the invalid request number %d',
  async (_, bytes) => {
    expect(await send(server.origin, bytes)).not.toMatch(/^HTTP\/1\.1 [23]/)
    await expectAlive()
  },
)

test.each(['/page/../../secret.txt', '/page/..%2Fsecret.txt', '/page/link.txt', '/page/', '/page', ''])(
  '%s, which is not a file of the page, is not found',
  async (path) => {
    expect(statusOf(await request(server.origin, `${base}${path}`))).toBe(404)
  },
)

test('nothing is served without the secret', async () => {
  expect(statusOf(await request(server.origin, '/page/index.html'))).toBe(404)
  expect(statusOf(await request(server.origin, `${base.slice(0, -1)}g/page/index.html`))).toBe(404)
})

test('requests with another host name are refused, because other sites can point a name to this address', async () => {
  for (const host of ['elsewhere.example', 'localhost', '127.0.0.1', '']) {
    expect(
      statusOf(await request(server.origin, `${base}/page/index.html`, { host })),
    ).toBeGreaterThanOrEqual(400)
  }
})

test.each(['PUT', 'DELETE', 'OPTIONS', 'PATCH', 'POST'])('%s of a file is not allowed', async (method) => {
  expect(statusOf(await request(server.origin, `${base}/page/index.html`, { method }))).toBe(405)
})

test('only offered files are served, unchanged', async () => {
  const path = join(folder, 'face # 100%.glb')
  const address = server.addressOf(path)
  expect(statusOf(await request(server.origin, new URL(address).pathname))).toBe(404)
  server.offer(path, Buffer.from('its bytes'))
  expect(await (await fetch(address)).text()).toBe('its bytes')
  server.offer(join(folder, 'set/a.png'), join(folder, 'secret.txt'))
  expect(await (await fetch(new URL('set/a.png', address))).text()).toBe(SECRET)
  server.offer(join(folder, 'gone.png'), join(folder, 'no-such-file'))
  expect((await fetch(server.addressOf(join(folder, 'gone.png')))).status).toBe(404)
  expect(pathToFileURL(path).pathname).toContain('%23')
})

test('an inbox accepts one picture, and only with the right length', async () => {
  const inbox = server.inbox(8)
  const post = async (body: string) => (await fetch(inbox.address, { method: 'POST', body })).status
  expect(await post('short')).toBe(413)
  expect(statusOf(await request(server.origin, new URL(inbox.address).pathname))).toBe(405)
  expect(inbox.received()).toBeUndefined()
  const long = request(server.origin, new URL(inbox.address).pathname, {
    method: 'POST',
    body: 'x'.repeat(10_000_000),
  })
  expect(statusOf(await long)).not.toBe(204)
  expect(inbox.received()).toBeUndefined()
  expect(await post('8 bytes!')).toBe(204)
  expect(await post('another!')).toBe(409)
  expect(String(inbox.received())).toBe('8 bytes!')
  await expectAlive()
})

test('a post that breaks off leaves the inbox open', async () => {
  const inbox = server.inbox(8)
  const { host, pathname } = new URL(inbox.address)
  await send(server.origin, `POST ${pathname} HTTP/1.1\r\nHost: ${host}\r\nContent-Length: 8\r\n\r\n8 by`)
  expect(inbox.received()).toBeUndefined()
  expect((await fetch(inbox.address, { method: 'POST', body: '8 bytes!' })).status).toBe(204)
})
