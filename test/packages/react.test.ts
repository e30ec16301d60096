// An app in React Three Fiber, in strict TypeScript, built by Vite from the packed package.

import { afterAll, beforeAll, expect, it } from 'vitest'
import { openPage } from '../pages/browser.ts'
import { DEPENDENCIES } from './npm.ts'
import { type ServedApp, serveApp } from './served-app.ts'
import { settled } from './settled.ts'

let served: ServedApp

beforeAll(async () => {
  const { three, types, react } = DEPENDENCIES
  served = await serveApp('react', [three, types, ...react])
})
afterAll(() => served?.close())

it.each([
  ['of a hook', ''],
  ["of a component round drei's <Gltf>", 'gltf'],
  ['on WebGPURenderer', 'webgpu'],
])('shows a surprised face by properties %s, and follows them', async (_, way) => {
  const { page, complaints } = await openPage(served.browser, { viewport: { width: 300, height: 300 } })
  await page.goto(`${served.origin}/?${way}`)
  const canvas = page.locator('canvas')
  await canvas.waitFor()
  const empty = await page.screenshot()
  const shown = await settled(page, empty)
  await canvas.click()
  await settled(page, shown)
  expect(complaints).toEqual([])
  await page.close()
})
