// Tests the packed packages as a new user would, in folders that contain only a character and the packages.

import { cp, mkdir, readFile, writeFile } from 'node:fs/promises'
import { basename, join } from 'node:path'
import type { Page } from 'playwright-core'
import { afterAll, beforeAll, describe, expect, inject, it } from 'vitest'
import { BARE_FACES } from '../bare-faces/bare-faces.ts'
import { openPage, useBrowser } from '../pages/browser.ts'
import {
  firstPicture,
  openPaused,
  playSurprise,
  readNextFrame,
  switchWrinkles,
} from '../pages/paused-page.ts'
import { contrast, largestDifference, WHOLE } from '../pages/pixels.ts'
import { startStaticServer } from '../pages/static-server.ts'
import { createApp, DEPENDENCIES, previewServer, ROOT, run, runUninstalled } from './npm.ts'
import { useFolder } from './pages.ts'

/** Scanned face if available, otherwise a shipped face without its wrinkles. */
const AVATAR = BARE_FACES.at(-1)!.path

const SIZE = { width: 300, height: 300 }

const folder = useFolder()
let app: string
const browser = useBrowser()

beforeAll(async () => {
  const { furrow, 'furrow-cli': cli } = inject('tarballs')
  const empty = join(folder(), 'empty')
  await mkdir(empty)
  await cp(AVATAR, join(empty, 'avatar.glb'))
  await cp(cli, join(empty, basename(cli)))
  // Makes small maps, to save time. `guide.test.ts` makes maps of default size.
  const options = ['-o', 'wrinkled.glb', '--size', '512']
  await runUninstalled(empty, `./${basename(cli)}`, 'auto', 'avatar.glb', ...options)

  const { three, types, vite, typescript } = DEPENDENCIES
  app = await createApp(join(folder(), 'app'), [furrow, three, types, vite, typescript])
  await cp(join(ROOT, 'test/packages/apps/vite'), app, { recursive: true })
  await cp(join(empty, 'wrinkled.glb'), join(app, 'public/wrinkled.glb'))
})

describe('an app in strict TypeScript, built by Vite', () => {
  let server: { origin: string; close(): Promise<void> }
  beforeAll(async () => {
    await run(app, 'npx', 'tsc')
    await run(app, 'npx', 'vite', 'build')
    server = await previewServer(app)
  })
  afterAll(() => server?.close())

  it.each(['webgl', 'webgpu'])('draws the wrinkles of a character with %s', (renderer) =>
    withPage(`${server.origin}/?${renderer}`, async (page) => {
      await firstPicture(page)
      await expectWrinkles(page, () => page.dispatchEvent('canvas', 'click'))
    }),
  )
})

it("draws a character's wrinkles on the README's page, without a bundler", async () => {
  const [, html] = (await readFile(join(ROOT, 'README.md'), 'utf8')).match(/```html\n(.*?)```/s)!
  await writeFile(join(app, 'page.html'), html.replace('/faces/human.glb', '/public/wrinkled.glb'))
  const server = await startStaticServer(app)
  try {
    await withPage(`${server.origin}/page.html`, async (page) => {
      await playSurprise(page)
      await expectWrinkles(page, () => switchWrinkles(page, 'off'))
    })
  } finally {
    server.close()
  }
})

/** Compares a page with and without wrinkles. */
async function expectWrinkles(page: Page, off: () => Promise<void>): Promise<void> {
  const wrinkled = await readNextFrame(page)
  expect(contrast(wrinkled)).toBeGreaterThan(100)
  await off()
  expect(largestDifference(wrinkled, await readNextFrame(page), WHOLE)).toBeGreaterThan(20)
}

/** Opens a page with its time paused. The page must report no errors or warnings. */
async function withPage(url: string, inspect: (page: Page) => Promise<void>): Promise<void> {
  const { page, complaints } = await openPage(browser(), { viewport: SIZE })
  try {
    await openPaused(page, url)
    await inspect(page)
    expect(complaints).toEqual([])
  } finally {
    await page.close()
  }
}
