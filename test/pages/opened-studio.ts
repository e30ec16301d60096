/** Serves the studio and opens it in a browser, for tests of its page. */

import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { Browser, Page } from 'playwright-core'
import { createServer, type Plugin, type ViteDevServer } from 'vite'
import { afterAll, afterEach, beforeAll, expect } from 'vitest'
import { writeAvatars } from './avatars.ts'
import { openBrowser, openPage } from './browser.ts'
import { waitUntilReady } from './studio-page.ts'

/**
 * Serves the studio from its sources, optionally with more Vite plugins. The caller must close the server.
 *
 * @returns the server, and the address of the studio with a shipped face.
 */
export async function serveStudio(
  plugins: Plugin[] = [],
): Promise<{ server: ViteDevServer; address: string }> {
  const server = await createServer({
    configFile: fileURLToPath(new URL('../../studio/vite.config.ts', import.meta.url)),
    logLevel: 'error',
    plugins,
    // Without this, a changed source file would reload the page during a test.
    server: { port: 0, host: '127.0.0.1', hmr: false, watch: null },
  })
  await server.listen()
  const { port } = server.httpServer!.address() as { port: number }
  return { server, address: `http://127.0.0.1:${port}/?face=human` }
}

interface OpenedStudio {
  page: Page
  complaints: string[]
  /** Temporary folder with the avatars that `write` has made. */
  folder: string
}

/**
 * Opens the studio for all tests of a file. Each test fails if the page has reported errors.
 *
 * @param write writes avatars for the tests into a folder.
 * @returns an object whose fields are set when the tests begin.
 */
export function openStudio(
  viewport: { width: number; height: number },
  write: (folder: string) => Promise<void> = writeAvatars,
): OpenedStudio {
  const studio = { folder: mkdtempSync(join(tmpdir(), 'furrow-studio-')) } as OpenedStudio
  let server: ViteDevServer
  let browser: Browser
  beforeAll(async () => {
    await write(studio.folder)
    const served = await serveStudio()
    server = served.server
    browser = await openBrowser()
    Object.assign(studio, await openPage(browser, { viewport, reducedMotion: 'reduce' }))
    await studio.page.goto(served.address)
    await waitUntilReady(studio.page)
  })
  afterAll(async () => {
    await browser?.close()
    await server?.close()
    rmSync(studio.folder, { recursive: true, force: true })
  })
  afterEach(async () => {
    expect(studio.complaints).toEqual([])
    expect(await studio.page.textContent('#errors')).toBe('')
  })
  return studio
}
