import { mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { createServer, type ViteDevServer } from 'vite'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { guard } from '../../studio/guard.ts'
import { serveExamples } from '../../studio/serve-examples.ts'
import { serveFaces } from '../../studio/serve-faces.ts'
import { HOSTILE_BYTES, HOSTILE_PATHS, request, send, statusOf } from '../hostile-requests.ts'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const SECRET = 'not to be served'

/** Contains `checkout`, a copy of the served folders with damaged faces, and `elsewhere`, a target of symbolic links in `checkout`. */
const folder = mkdtempSync(join(tmpdir(), 'furrow-studio-'))
const checkout = join(folder, 'checkout')
const warnings: string[] = []
let server: ViteDevServer
let origin: string

beforeAll(async () => {
  for (const name of [
    'studio',
    'faces/folder.glb',
    'faces/builder',
    'examples',
    'node_modules',
    '../elsewhere',
  ]) {
    mkdirSync(join(checkout, name), { recursive: true })
  }
  const put = (name: string, content: string | Uint8Array) => writeFileSync(join(checkout, name), content)
  const face = readFileSync(join(ROOT, 'faces/human.glb'))
  put('faces/good.glb', face)
  put('faces/cut-off.glb', face.subarray(0, 100_000))
  put('faces/header.glb', face.subarray(0, 10))
  put('faces/empty.glb', '')
  put('faces/text.glb', 'no face, but longer than a header')
  put('faces/builder/mask.png', 'an image of the builder')
  put('examples/page.html', '<!doctype html><title>An example</title>')
  put('studio/index.html', '<!doctype html><title>The studio</title>')
  put('../elsewhere/secret.html', SECRET)
  put('../elsewhere/secret.json', JSON.stringify(SECRET))
  put('../elsewhere/secret.glb', face)
  const link = (to: string, from: string) => symlinkSync(join(folder, to), join(checkout, from))
  link('elsewhere/secret.glb', 'faces/linked.glb')
  link('elsewhere/secret.json', 'faces/linked.json')
  link('elsewhere', 'faces/linked')
  link('elsewhere/secret.html', 'examples/linked.html')
  link('elsewhere/secret.json', 'examples/linked.json')
  server = await createServer({
    configFile: false,
    root: join(checkout, 'studio'),
    appType: 'mpa',
    plugins: [
      serveFaces(join(checkout, 'faces')),
      serveExamples(join(checkout, 'examples')),
      guard(checkout),
    ],
    server: { host: '127.0.0.1', port: 0, fs: { allow: [checkout] }, watch: null },
    logLevel: 'warn',
    customLogger: {
      ...silent,
      warnOnce: (text) => void warnings.push(text),
    },
  })
  await server.listen()
  origin = server.resolvedUrls!.local[0]!
})

const silent = {
  info() {},
  warn() {},
  warnOnce() {},
  error() {},
  clearScreen() {},
  hasErrorLogged: () => false,
  hasWarned: false,
}

afterAll(async () => {
  await server.close()
  rmSync(folder, { recursive: true })
})

async function expectAlive(): Promise<void> {
  expect(await (await fetch(origin)).text()).toContain('The studio')
  expect(await (await fetch(new URL('faces/index.json', origin))).json()).toEqual(['good'])
  expect((await fetch(new URL('faces/good.glb', origin))).status).toBe(200)
}

test('unreadable faces are left out of the list, with one line each', async () => {
  await expectAlive()
  const left = warnings.map(
    (text) => /^faces: skipped "(.*)", got an incomplete .glb \(.*\)$/.exec(text)?.[1],
  )
  expect([...new Set(left)].sort()).toEqual(['cut-off.glb', 'empty.glb', 'header.glb', 'text.glb'])
})

test.each(HOSTILE_PATHS.map((path) => [path.slice(0, 40), path]))(
  'the server continues after GET %s',
  async (_, path) => {
    for (const prefix of ['', '/faces', '/examples', '/@fs', `/@fs${checkout}/faces`, '/@id']) {
      const response = await request(origin, `${prefix}${path}`)
      expect(response).not.toContain(SECRET)
      expect(response).not.toContain('root:')
      if (prefix === '/faces') expect(statusOf(response)).toBeGreaterThanOrEqual(400)
    }
    await expectAlive()
  },
)

test.each(HOSTILE_BYTES.map((bytes, i) => [i, bytes] as const))(
  'the server continues after the invalid request number %d',
  async (_, bytes) => {
    await send(origin, bytes)
    await expectAlive()
  },
)

test.each([
  ['/faces/%', 400],
  ['/faces/missing.glb', 404],
  ['/faces/folder.glb', 404],
  ['/faces/linked.glb', 404],
  ['/faces/linked.json', 404],
  ['/faces/linked/secret.glb', 404],
  ['/faces/builder/mask.png', 404],
  ['/examples/missing.html', 404],
  ['/examples/linked.html', 404],
  ['/examples/linked.json', 404],
  [`/@fs${checkout}/faces/linked.json`, 404],
  [`/@fs${checkout}/faces/linked.json?import`, 404],
  [`/@fs${checkout}/faces/linked.json?raw`, 404],
  [`/@fs${checkout}/faces/linked/secret.json`, 404],
  [`/@fs${folder}/elsewhere/secret.json`, 404],
  [`/@fs${folder}/elsewhere/missing.json`, 404],
  ['/__open-in-editor?file=package.json', 404],
  ['/__OPEN-in-editor/?file=package.json', 404],
] as const)('GET %s returns %d', async (path, status) => {
  const response = await request(origin, path)
  expect(statusOf(response)).toBe(status)
  expect(response).not.toContain(SECRET)
})

test('an example and its files are served', async () => {
  expect(await (await fetch(new URL('examples/page.html', origin))).text()).toContain('An example')
  expect((await fetch(new URL(`@fs${checkout}/faces/good.glb`, origin))).status).toBe(200)
})
