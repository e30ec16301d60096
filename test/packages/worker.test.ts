// Tests that the packed `furrow/auto` starts its web worker without configuration, on pages with and without a bundler.

import { cp, readdir, readFile, writeFile } from 'node:fs/promises'
import { join } from 'node:path'
import { beforeAll, expect, inject, it } from 'vitest'
import { useBrowser } from '../pages/browser.ts'
import { createApp, DEPENDENCIES, ROOT, run } from './npm.ts'
import { buildByEsbuild, buildByWebpack, importOf, titleAt, titleOf, useFolder } from './pages.ts'

const MADE = '1 area, 262144 bytes, ends with done'

const folder = useFolder()
let app: string
const browser = useBrowser()

beforeAll(async () => {
  const { vite, webpack, esbuild } = DEPENDENCIES
  app = await createApp(join(folder(), 'app'), [inject('tarballs').furrow, vite, webpack, esbuild])
  await cp(join(ROOT, 'test/packages/apps/worker'), app, { recursive: true })
})

it('runs on a page without a bundler', async () => {
  expect(await titleOf(browser(), app, 'plain.html')).toBe(MADE)
})

it('reports what to allow on a page that forbids its worker', async () => {
  const plain = await readFile(join(app, 'plain.html'), 'utf8')
  const policy = `<meta http-equiv="Content-Security-Policy" content="worker-src 'self'">`
  await writeFile(join(app, 'strict.html'), plain.replace('<title>', `${policy}<title>`))
  expect(await titleOf(browser(), app, 'strict.html')).toBe(
    'autoWrinklesInWorker: the worker cannot start; allow `worker-src blob:` in the Content-Security-Policy of the page',
  )
})

it("runs on Vite's development server", async () => {
  const { createServer }: typeof import('vite') = await importOf(app, 'vite/dist/node/index.js')
  const server = await createServer({ root: app, logLevel: 'warn', server: { host: '127.0.0.1', port: 0 } })
  await server.listen()
  try {
    expect(await titleAt(browser(), server.resolvedUrls!.local[0]!)).toBe(MADE)
  } finally {
    await server.close()
  }
})

it('runs as built by Vite, in a chunk that is fetched on use', async () => {
  await run(app, 'npx', 'vite', 'build')
  const dist = join(app, 'dist')
  expect(await titleOf(browser(), dist, 'index.html')).toBe(MADE)
  const [page] = (await readdir(join(dist, 'assets'))).filter((file) => file.startsWith('index-'))
  expect((await readFile(join(dist, 'assets', page!))).length).toBeLessThan(15_000)
})

it('runs as built by webpack', async () => {
  expect(await titleOf(browser(), await buildByWebpack(app), 'index.html')).toBe(MADE)
})

it.each([false, true])('runs as built by esbuild, in several files: %s', async (maySplit) => {
  expect(await titleOf(browser(), await buildByEsbuild(app, maySplit), 'index.html')).toBe(MADE)
})
