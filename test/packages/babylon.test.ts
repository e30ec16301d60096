// An app in Babylon.js, in strict TypeScript, built by Vite from the packed package.

import { afterAll, beforeAll, expect, it } from 'vitest'
import { openPage } from '../pages/browser.ts'
import { DEPENDENCIES } from './npm.ts'
import { type ServedApp, serveApp } from './served-app.ts'
import { settled } from './settled.ts'

let served: ServedApp

beforeAll(async () => {
  served = await serveApp('babylon', DEPENDENCIES.babylon)
})
afterAll(() => served?.close())

it.each([
  ['WebGL 2', ''],
  ['WebGPU', 'webgpu'],
])(
  'shows a surprised face on %s, and the same without wrinkles, from its own files alone',
  async (_, way) => {
    const { page, complaints } = await openPage(served.browser, { viewport: { width: 300, height: 300 } })
    const foreign: string[] = []
    page.on('request', (request) => {
      if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(served.origin))
        foreign.push(request.url())
    })
    await page.goto(`${served.origin}/?${way}`)
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
