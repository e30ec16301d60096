// Tests that the packed loader loads relief as a separate chunk, on pages built by bundlers and on a page without one.

import { cp } from 'node:fs/promises'
import { join } from 'node:path'
import { beforeAll, expect, inject, it } from 'vitest'
import { useBrowser } from '../pages/browser.ts'
import { createApp, DEPENDENCIES, ROOT, run } from './npm.ts'
import { buildByEsbuild, buildByWebpack, titleOf, useFolder } from './pages.ts'

const AT_ONCE = 'morph 0.5; input 0.25; relief'
const IN_CHUNKS = 'morph 0.5; input 0.25; relief fetched'

const folder = useFolder()
let app: string
const browser = useBrowser()

beforeAll(async () => {
  const { three, vite, webpack, esbuild } = DEPENDENCIES
  app = await createApp(join(folder(), 'app'), [inject('tarballs').furrow, three, vite, webpack, esbuild])
  await cp(join(ROOT, 'test/packages/apps/chunks'), app, { recursive: true })
})

it('work on a page without a bundler', async () => {
  expect(await titleOf(browser(), app, 'plain.html')).toBe(IN_CHUNKS)
})

it('are fetched as built by Vite', async () => {
  await run(app, 'npx', 'vite', 'build', '--target', 'esnext')
  expect(await titleOf(browser(), join(app, 'dist'), 'index.html')).toBe(IN_CHUNKS)
})

it('are fetched as built by webpack', async () => {
  expect(await titleOf(browser(), await buildByWebpack(app), 'index.html')).toBe(IN_CHUNKS)
})

it.each([
  [false, AT_ONCE],
  [true, IN_CHUNKS],
])('work as built by esbuild, in chunks: %s', async (maySplit, title) => {
  expect(await titleOf(browser(), await buildByEsbuild(app, maySplit), 'index.html')).toBe(title)
})
