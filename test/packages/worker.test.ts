// `furrow/auto` as published, in pages made by bundlers and by none: each starts its worker without any setting.

import { cp, readdir, readFile, writeFile } from 'node:fs/promises'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import type { Browser } from 'playwright-core'
import { afterAll, beforeAll, expect, it } from 'vitest'
import { openBrowser, openPage } from '../pages/browser.ts'
import { startStaticServer } from '../pages/static-server.ts'
import { createApp, DEPENDENCIES, pack, ROOT, remove, run, temporaryFolder } from './npm.ts'

const MADE = '1 area, 262144 bytes, ends with done'

let folder: string
let app: string
let browser: Browser

beforeAll(async () => {
  folder = await temporaryFolder()
  const { vite, webpack, esbuild } = DEPENDENCIES
  app = await createApp(join(folder, 'app'), [await pack('furrow', folder), vite, webpack, esbuild])
  await cp(join(ROOT, 'test/packages/apps/worker'), app, { recursive: true })
  browser = await openBrowser()
})

afterAll(async () => {
  await browser?.close()
  await remove(folder)
})

it('runs on a page without a bundler', async () => {
  expect(await titleOf(app, 'plain.html')).toBe(MADE)
})

it('tells a page that forbids its worker what to allow', async () => {
  const plain = await readFile(join(app, 'plain.html'), 'utf8')
  const policy = `<meta http-equiv="Content-Security-Policy" content="worker-src 'self'">`
  await writeFile(join(app, 'strict.html'), plain.replace('<title>', `${policy}<title>`))
  expect(await titleOf(app, 'strict.html')).toBe(
    'autoWrinklesInWorker: the worker cannot be started; allow `worker-src blob:` in the Content-Security-Policy of the page',
  )
})

it("runs on Vite's development server", async () => {
  const { createServer }: typeof import('vite') = await importOf('vite/dist/node/index.js')
  const server = await createServer({ root: app, logLevel: 'warn', server: { host: '127.0.0.1', port: 0 } })
  await server.listen()
  try {
    expect(await titleAt(server.resolvedUrls!.local[0]!)).toBe(MADE)
  } finally {
    await server.close()
  }
})

it('runs as built by Vite, in a file that is fetched when it is used', async () => {
  await run(app, 'npx', 'vite', 'build')
  const dist = join(app, 'dist')
  expect(await titleOf(dist, 'index.html')).toBe(MADE)
  const [page] = (await readdir(join(dist, 'assets'))).filter((file) => file.startsWith('index-'))
  expect((await readFile(join(dist, 'assets', page!))).length).toBeLessThan(10_000)
})

it('runs as built by webpack', async () => {
  const { default: webpack } = await importOf('webpack/lib/index.js')
  const settings = {
    context: app,
    entry: './main.js',
    mode: 'production',
    output: { path: join(app, 'webpack'), filename: 'main.js' },
  }
  const problems = await new Promise((resolve, reject) => {
    webpack(settings, (error: Error | null, result: { compilation: { errors: unknown[] } }) =>
      error ? reject(error) : resolve(result.compilation.errors),
    )
  })
  expect(problems).toEqual([])
  await cp(join(app, 'index.html'), join(app, 'webpack/index.html'))
  expect(await titleOf(join(app, 'webpack'), 'index.html')).toBe(MADE)
})

it.each(['in one file', 'in several'])('runs as built by esbuild %s', async (form) => {
  const options = form === 'in several' ? ['--splitting'] : []
  const out = join(app, `esbuild ${form}`)
  await run(
    app,
    'npx',
    'esbuild',
    'main.js',
    '--bundle',
    '--minify',
    '--format=esm',
    `--outdir=${out}`,
    ...options,
  )
  await cp(join(app, 'index.html'), join(out, 'index.html'))
  expect(await titleOf(out, 'index.html')).toBe(MADE)
})

function importOf(path: string) {
  return import(pathToFileURL(join(app, 'node_modules', path)).href)
}

async function titleOf(root: string, page: string): Promise<string> {
  const server = await startStaticServer(root)
  try {
    return await titleAt(`${server.origin}/${page}`)
  } finally {
    server.close()
  }
}

/** The title of a page when it has done its work. */
async function titleAt(url: string): Promise<string> {
  const { page } = await openPage(browser)
  try {
    await page.goto(url)
    await page.waitForFunction(() => document.title !== 'working', undefined, { timeout: 0 })
    return await page.title()
  } finally {
    await page.close()
  }
}
