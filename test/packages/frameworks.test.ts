// Builds the code blocks of docs/frameworks.md with Vite, with the packed `furrow`, and opens the resulting pages.

import { cp, readFile, writeFile } from 'node:fs/promises'
import { join } from 'node:path'
import type { Browser } from 'playwright-core'
import { afterAll, beforeAll, describe, expect, inject, it } from 'vitest'
import { openBrowser, openPage } from '../pages/browser.ts'
import { createApp, DEPENDENCIES, previewServer, ROOT, remove, run, temporaryFolder } from './npm.ts'
import { settled } from './settled.ts'

const { three, vite } = DEPENDENCIES

describe.each([
  {
    name: 'threlte',
    packages: [three, '@threlte/core@8.6.0', 'svelte@5.57.3', '@sveltejs/vite-plugin-svelte@7.3.1'],
    recipe: { 'Face.svelte': ['svelte', 0], 'LiveFace.svelte': ['svelte', 1] },
    isLive: true,
  },
  {
    name: 'tres',
    packages: [three, '@tresjs/core@5.9.1', 'vue@3.5.45', '@vitejs/plugin-vue@6.0.11'],
    recipe: { 'Face.vue': ['vue', 0] },
    isLive: false,
  },
  {
    name: 'aframe',
    packages: ['three@npm:super-three@0.184.0', 'aframe@1.8.0'],
    // A-Frame depends on a fork of this package on GitHub, which some machines cannot reach. Its build already contains the fork.
    overrides: { 'three-bmfont-text': '3.0.1' },
    recipe: { 'component.ts': ['ts', 0], 'live-face.ts': ['ts', 1], 'scene.html': ['html', 0] },
    isLive: true,
  },
])('the recipe for $name', ({ name, packages, overrides, recipe, isLive }) => {
  let folder: string
  let browser: Browser
  let server: Awaited<ReturnType<typeof previewServer>>

  beforeAll(async () => {
    folder = await temporaryFolder()
    const app = await createApp(join(folder, 'app'), [inject('tarballs').furrow, vite, ...packages], {
      overrides,
    })
    await cp(join(ROOT, 'test/packages/apps/frameworks'), app, { recursive: true })
    const page = await readFile(join(ROOT, 'docs/frameworks.md'), 'utf8')
    for (const [file, [language, index]] of Object.entries(recipe)) {
      const blocks = [...page.matchAll(new RegExp(`^\`\`\`${language}\n([\\s\\S]*?)^\`\`\`$`, 'gm'))]
      await writeFile(join(app, name, file), blocks[index as number]![1]!)
    }
    await run(app, 'npx', 'vite', 'build', name, '--base', `/${name}/`, '--outDir', `../dist/${name}`)
    await cp(join(ROOT, 'faces/human.glb'), join(app, 'dist/face.glb'))
    server = await previewServer(app)
    browser = await openBrowser()
  })
  afterAll(async () => {
    await browser?.close()
    await server?.close()
    await remove(folder)
  })

  /** Saves a picture in the folder FURROW_PICTURES, if set. */
  async function keep(state: string, png: Buffer): Promise<void> {
    const pictures = process.env.FURROW_PICTURES
    if (pictures) await writeFile(join(pictures, `${name}-${state}.png`), png)
  }

  it('shows a face that wrinkles as its blendshapes move', async () => {
    const { page, complaints } = await openPage(browser, { viewport: { width: 300, height: 300 } })
    let mayLoad = () => {}
    const loading = new Promise<void>((resolve) => {
      mayLoad = resolve
    })
    await page.route('**/*.glb', (route) => loading.then(() => route.continue()))
    await page.goto(`${server.origin}/${name}/`)
    await page.locator('canvas').waitFor()
    const blank = await page.screenshot()
    mayLoad()
    await expect.poll(() => page.title(), { timeout: 120_000 }).toMatch(/^\d+ areas$/)
    const shown = await settled(page, blank)
    await keep('shown', shown)
    await page.mouse.click(150, 150)
    const wrinkled = await settled(page, shown)
    await keep('wrinkled', wrinkled)
    await page.mouse.click(150, 150)
    await keep('plain', await settled(page, wrinkled))
    expect(complaints).toEqual([])
  })

  it.runIf(isLive)('moves the face by furrow live', async () => {
    const { page, complaints } = await openPage(browser, { viewport: { width: 300, height: 300 } })
    const sockets: { send(text: string): void }[] = []
    await page.routeWebSocket('ws://127.0.0.1:8765/?token=x', (socket) => void sockets.push(socket))
    const blank = await page.screenshot()
    await page.goto(`${server.origin}/${name}/?live`)
    await expect.poll(() => page.title(), { timeout: 120_000 }).toMatch(/^\d+ areas$/)
    const rest = await settled(page, blank)
    await expect.poll(() => sockets.length).toBeGreaterThan(0)
    const scores = { browInnerUp: 1, browOuterUpLeft: 1, browOuterUpRight: 1 }
    for (const time of [1, 2]) sockets[0]!.send(JSON.stringify({ source: 'vmc', time, scores }))
    await keep('live', await settled(page, rest))
    expect(complaints).toEqual([])
  })
})
