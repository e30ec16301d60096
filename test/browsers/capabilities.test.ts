/** Records each browser's version and graphics APIs for the table of browsers in README.md, and tests the studio and an example. */

import type { ViteDevServer } from 'vite'
import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import { FOREHEAD } from '../pages/examples.ts'
import { serveStudio } from '../pages/opened-studio.ts'
import { startStaticServer } from '../pages/static-server.ts'
import { DRIVEN } from './drive/browsers.ts'
import { withHelper } from './page-helper.ts'
import { openWindow } from './window.ts'

declare module 'vitest' {
  interface TaskMeta {
    /** Capabilities of a browser, read by `scripts/browsers.mjs`. */
    browser?: { version?: string; webgl2?: boolean; webgpu?: boolean; auto?: boolean; studio?: boolean }
  }
}

let server: Awaited<ReturnType<typeof startStaticServer>>
let studio: { server: ViteDevServer; address: string }

beforeAll(async () => {
  server = await startStaticServer(undefined, withHelper)
  studio = await serveStudio([{ name: 'helper', transformIndexHtml: withHelper }])
})

afterAll(async () => {
  server?.close()
  await studio?.server.close()
})

describe.each(DRIVEN)('in %s', (_, kind) => {
  const window = openWindow(kind)

  test('the studio opens and shows its first face', async ({ task }) => {
    await window.resize(1120, 700)
    await window.browser.open(studio.address)
    await window.until("document.querySelector('#stage[aria-busy=false]')")
    await window.save('studio')
    const found = await window.evaluate<{ webgl2: boolean; webgpu: boolean }>(`
      const context = document.createElement('canvas').getContext('webgl2')
      return { webgl2: context !== null, webgpu: Boolean(await navigator.gpu?.requestAdapter()) }`)
    expect(found.webgl2).toBe(true)
    task.meta.browser = { version: window.browser.version, ...found, studio: true }
  })

  test('the example auto.html makes wrinkles and shows them', async ({ task }) => {
    await window.resize(450, 480)
    await window.browser.open(`${server.origin}/examples/auto.html`)
    await window.until("document.querySelector('canvas') && !document.querySelector('progress')")
    await window.waitForWrinkles(FOREHEAD)
    await window.save('auto')
    task.meta.browser = { auto: true }
  })
})
