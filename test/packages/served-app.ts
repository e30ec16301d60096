import { cp } from 'node:fs/promises'
import { join } from 'node:path'
import type { Browser } from 'playwright-core'
import { inject } from 'vitest'
import { openBrowser } from '../pages/browser.ts'
import { createApp, DEPENDENCIES, previewServer, ROOT, remove, run, temporaryFolder } from './npm.ts'

/** Address of an app, and a browser to open it in. */
export interface ServedApp {
  origin: string
  browser: Browser
  close(): Promise<void>
}

/**
 * Builds an app of `apps` by Vite, with the packed `furrow` and the shipped face, and serves the build.
 *
 * @param packages packages to install besides `furrow`, Vite and TypeScript.
 * @param without source files to leave out.
 */
export async function serveApp(
  source: string,
  packages: readonly string[],
  without: readonly string[] = [],
): Promise<ServedApp> {
  const folder = await temporaryFolder()
  const { vite, typescript } = DEPENDENCIES
  const app = await createApp(join(folder, 'app'), [inject('tarballs').furrow, vite, typescript, ...packages])
  await cp(join(ROOT, 'test/packages/apps', source), app, { recursive: true })
  for (const file of without) await remove(join(app, file))
  await cp(join(ROOT, 'faces/human.glb'), join(app, 'public/wrinkled.glb'))
  await run(app, 'npx', 'tsc')
  await run(app, 'npx', 'vite', 'build')
  const server = await previewServer(app)
  const browser = await openBrowser()
  const close = async () => {
    await browser.close()
    await server.close()
    await remove(folder)
  }
  return { origin: server.origin, browser, close }
}
