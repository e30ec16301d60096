// An app in React Three Fiber, in strict TypeScript, built by Vite from the packed package.

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
  const { three, types, vite, typescript, react } = DEPENDENCIES
  const tarball = await pack('furrow', folder)
  const app = await createApp(join(folder, 'app'), [tarball, three, types, vite, typescript, ...react])
  await cp(join(ROOT, 'test/packages/apps/react'), app, { recursive: true })
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
  ['of a hook', ''],
  ["of a component round drei's <Gltf>", 'gltf'],
  ['on WebGPURenderer', 'webgpu'],
])('shows a surprised face by properties %s, and follows them', async (_, way) => {
  const { page, complaints } = await openPage(browser, { viewport: { width: 300, height: 300 } })
  await page.goto(`${server.origin}/?${way}`)
  const canvas = page.locator('canvas')
  await canvas.waitFor()
  const empty = await page.screenshot()
  const shown = await settled(page, empty)
  await canvas.click()
  await settled(page, shown)
  expect(complaints).toEqual([])
  await page.close()
})
