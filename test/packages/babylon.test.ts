// An app in Babylon.js, in strict TypeScript, built by Vite from the packed package.

import { cp } from 'node:fs/promises'
import { join } from 'node:path'
import type { Browser } from 'playwright-core'
import { afterAll, beforeAll, expect, it } from 'vitest'
import { openBrowser, openPage } from '../pages/browser.ts'
import { createApp, DEPENDENCIES, pack, previewServer, ROOT, remove, run, temporaryFolder } from './npm.ts'
import { settled } from './settled.ts'

let folder: string
let browser: Browser
let server: { origin: string; close(): Promise<void> }

beforeAll(async () => {
  folder = await temporaryFolder()
  const { vite, typescript, babylon } = DEPENDENCIES
  const tarball = await pack('furrow', folder)
  const app = await createApp(join(folder, 'app'), [tarball, vite, typescript, ...babylon])
  await cp(join(ROOT, 'test/packages/apps/babylon'), app, { recursive: true })
  await cp(join(ROOT, 'faces/human.glb'), join(app, 'public/wrinkled.glb'))
  await run(app, 'npx', 'tsc')
  await run(app, 'npx', 'vite', 'build')
  server = await previewServer(app)
  browser = await openBrowser()
})

afterAll(async () => {
  await browser?.close()
  await server?.close()
  await remove(folder)
})

it.each([
  ['WebGL 2', ''],
  ['WebGPU', 'webgpu'],
])(
  'shows a surprised face on %s, and the same without wrinkles, from its own files alone',
  async (_, way) => {
    const { page, complaints } = await openPage(browser, { viewport: { width: 300, height: 300 } })
    const foreign: string[] = []
    page.on('request', (request) => {
      if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(server.origin))
        foreign.push(request.url())
    })
    await page.goto(`${server.origin}/?${way}`)
    const canvas = page.locator('canvas')
    await canvas.waitFor()
    const empty = await page.screenshot()
    const shown = await settled(page, empty)
    await canvas.click()
    await settled(page, shown)
    expect(complaints).toEqual([])
    expect(foreign).toEqual([])
    await page.close()
  },
)
