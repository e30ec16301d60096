import { cp } from 'node:fs/promises'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import type { Browser } from 'playwright-core'
import { afterAll, beforeAll } from 'vitest'
import { openPage } from '../pages/browser.ts'
import { startStaticServer } from '../pages/static-server.ts'
import { remove, run, temporaryFolder } from './npm.ts'

/** Creates a temporary folder for all tests of a file. */
export function useFolder(): () => string {
  let folder = ''
  beforeAll(async () => {
    folder = await temporaryFolder()
  })
  afterAll(() => remove(folder))
  return () => folder
}

/** Imports a module of a package installed in an app. */
export function importOf(app: string, path: string) {
  return import(pathToFileURL(join(app, 'node_modules', path)).href)
}

/** Builds `main.js` of an app with webpack. Returns the output folder, including the app's `index.html`. */
export async function buildByWebpack(app: string): Promise<string> {
  const { default: webpack } = await importOf(app, 'webpack/lib/index.js')
  const path = join(app, 'webpack')
  const settings = {
    context: app,
    entry: './main.js',
    mode: 'production',
    output: { path, filename: 'main.js' },
  }
  const problems = await new Promise<unknown[]>((resolve, reject) => {
    webpack(settings, (error: Error | null, result: { compilation: { errors: unknown[] } }) =>
      error ? reject(error) : resolve(result.compilation.errors),
    )
  })
  if (problems.length > 0) throw new Error(problems.join('\n'))
  await cp(join(app, 'index.html'), join(path, 'index.html'))
  return path
}

/** Builds an app with esbuild, in one file or, with `maySplit`, in several. */
export async function buildByEsbuild(app: string, maySplit: boolean): Promise<string> {
  const path = join(app, maySplit ? 'esbuild in several' : 'esbuild in one file')
  const options = ['--bundle', '--minify', '--format=esm', `--outdir=${path}`]
  await run(app, 'npx', 'esbuild', 'main.js', ...options, ...(maySplit ? ['--splitting'] : []))
  await cp(join(app, 'index.html'), join(path, 'index.html'))
  return path
}

/** Serves a folder and returns the title of a page in it, once the page has finished. */
export async function titleOf(browser: Browser, root: string, page: string): Promise<string> {
  const server = await startStaticServer(root)
  try {
    return await titleAt(browser, `${server.origin}/${page}`)
  } finally {
    server.close()
  }
}

/** Opens a page and returns its title, once the title is no longer `working`. */
export async function titleAt(browser: Browser, url: string): Promise<string> {
  const { page } = await openPage(browser)
  try {
    await page.goto(url)
    await page.waitForFunction(() => document.title !== 'working', undefined, { timeout: 0 })
    return await page.title()
  } finally {
    await page.close()
  }
}
