// Tests the built site under a path other than the one it was built for. Run: `npm run test:all -- --project site`.

import { spawnSync } from 'node:child_process'
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import type { Page } from 'playwright-core'
import sharp from 'sharp'
import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { exampleNames } from '../../scripts/lib/examples.mjs'
import { serveSite } from '../../site/serve.mjs'
import { BARE_FACES } from '../bare-faces/bare-faces.ts'
import { openPage, useBrowser } from '../pages/browser.ts'
import { contrast, largestDifference, type Region, WHOLE } from '../pages/pixels.ts'
import type { CanvasPixels } from '../pages/read-canvas.ts'

const DIST = new URL('../../site/dist/', import.meta.url)

const PHONE = { width: 390, height: 844 }
const DESKTOP = { width: 960, height: 640 }

/** One page of each kind. */
const PAGES = [
  'index.html',
  'overview.html',
  'docs/guide.html',
  'docs/paper.html',
  'docs/FURROW_wrinkle_maps.html',
  'docs/api/furrow.three.html',
  'commands/auto.html',
  'examples/index.html',
  'bench/index.html',
  'faces/human/index.html',
]

/** Forehead of the face on the first page, as fractions of its square picture. */
const FOREHEAD: Region = { left: 0.35, top: 0.2, right: 0.65, bottom: 0.38 }

const browser = useBrowser()
let site: Awaited<ReturnType<typeof serveSite>>

beforeAll(async () => {
  if (!existsSync(DIST)) throw new Error('site: site/dist is missing; run npm run site')
  site = await serveSite()
})

afterAll(async () => {
  await site?.close()
})

/** Opens a page of the site. Fails if a request fails or leaves the site. */
async function withPage(path: string, options: object, work: (page: Page) => Promise<void>): Promise<void> {
  const { page, complaints } = await openPage(browser(), options)
  page.on('request', (request) => {
    if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(site.address)) {
      complaints.push(`asks for ${request.url()}`)
    }
  })
  try {
    await page.goto(new URL(path, site.address).href)
    await work(page)
    expect(complaints).toEqual([])
  } finally {
    await page.context().close()
  }
}

/** Waits until the page is interactive. */
async function mounted(page: Page): Promise<void> {
  await page.waitForFunction(() => '__vue_app__' in document.getElementById('app')!)
}

/** Takes a picture of the face on the first page. */
async function faceOf(page: Page): Promise<CanvasPixels> {
  return pixelsOf(await page.locator('.stage .face').screenshot())
}

/** Takes pictures of the face until two consecutive ones are equal, and returns the last. */
async function settled(page: Page): Promise<CanvasPixels> {
  let last = await faceOf(page)
  for (;;) {
    await page.evaluate(threeFrames)
    const next = await faceOf(page)
    if (Buffer.compare(last.data, next.data) === 0) return next
    last = next
  }
}

async function threeFrames(): Promise<void> {
  for (let i = 0; i < 3; i++) await new Promise(requestAnimationFrame)
}

describe('the built site, under another path', () => {
  it.each(PAGES)('%s requests no missing or external file, and fits a phone', async (path) => {
    await withPage(path, { viewport: PHONE }, async (page) => {
      await page.waitForLoadState('networkidle')
      expect(await page.locator('h1').first().innerText()).not.toBe('404')
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(PHONE.width)
    })
  })

  it('has no links that begin with a slash', () => {
    const pages = readdirSync(DIST, { recursive: true, encoding: 'utf8' }).filter((path) =>
      path.endsWith('.html'),
    )
    expect(pages.length).toBeGreaterThan(50)
    // A server may return the not-found page for any path, so links in that page must be absolute.
    const wrong = pages
      .filter((path) => path !== '404.html')
      .flatMap((path) => {
        const html = readFileSync(new URL(path, DIST), 'utf8')
        return [...html.matchAll(/<[^>]* (?:href|src)="(\/[^"]*)"/g)].map(
          ([, address]) => `${path}: ${address}`,
        )
      })
    expect(wrong).toEqual([])
  })

  it('has a page for every command, with all of its options', () => {
    const help = (...words: string[]) =>
      spawnSync(process.execPath, ['packages/cli/bin/furrow.js', ...words], { encoding: 'utf8' }).stdout
    const commands = [...help('--help').matchAll(/^ {2}(\w+)\b.*/gm)].map(([, name]) => name)
    const names = commands.filter((name) => name !== 'help')
    expect(names.length).toBeGreaterThan(10)
    for (const name of names) {
      const html = readFileSync(new URL(`commands/${name}.html`, DIST), 'utf8')
      const options = [...help('help', name).matchAll(/^ {2}(?:-\w, )?(--[\w-]+)/gm)].map(
        ([, option]) => option,
      )
      for (const option of options) expect(html, name).toContain(option)
    }
  })
})

describe('the first page', () => {
  it('shows a face that wrinkles under the pointer', async () => {
    await withPage('', { viewport: DESKTOP }, async (page) => {
      // Before the first input the page shows a still image and draws nothing.
      expect(await page.locator('canvas.drawn').count()).toBe(0)
      await mounted(page)
      const { x, y, width, height } = (await page.locator('.stage .face').boundingBox())!
      await page.mouse.move(x + width / 2, y + height / 2)
      await page.locator('canvas.drawn').waitFor()
      await page.mouse.move(x + width / 2, y + 10)
      const surprised = await settled(page)
      await page.getByLabel('wrinkles', { exact: true }).uncheck()
      const smooth = await settled(page)
      expect(contrast(surprised)).toBeGreaterThan(100)
      expect(largestDifference(surprised, smooth, FOREHEAD)).toBeGreaterThan(20)
      await page.getByLabel('wrinkles', { exact: true }).check()
      // A pointer on the middle of the face gives the neutral expression.
      await page.mouse.move(x + width / 2, y + height / 2)
      const neutral = await settled(page)
      expect(largestDifference(surprised, neutral, FOREHEAD)).toBeGreaterThan(20)
    })
  })

  it("makes wrinkles for a visitor's avatar, by keyboard alone", async () => {
    await withPage('', { viewport: DESKTOP }, async (page) => {
      await mounted(page)
      await page.getByLabel('Open your avatar').setInputFiles(BARE_FACES[0].path)
      await expect
        .poll(() => page.locator('.stage .message').innerText(), { timeout: 240_000, interval: 500 })
        .toMatch(/now has wrinkles\. The file was not uploaded/)
      await page.getByRole('button', { name: 'surprised' }).focus()
      await page.keyboard.press('Enter')
      const wrinkled = await settled(page)
      await page.getByLabel('wrinkles', { exact: true }).focus()
      await page.keyboard.press('Space')
      // The avatar is white, so its wrinkles are faint.
      expect(largestDifference(wrinkled, await settled(page), WHOLE)).toBeGreaterThan(4)
    })
  })

  it('says what is wrong with an invalid file, and keeps the face', async () => {
    await withPage('', { viewport: DESKTOP }, async (page) => {
      const file = { name: 'notes.glb', mimeType: 'model/gltf-binary', buffer: Buffer.from('not a face') }
      await mounted(page)
      await page.getByLabel('Open your avatar').setInputFiles(file)
      await page.getByText('notes.glb cannot be opened').waitFor()
      expect(contrast(await settled(page))).toBeGreaterThan(100)
    })
  })

  it('keeps the still image without WebGL, and says why', async () => {
    const { page } = await openPage(browser(), { viewport: DESKTOP })
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = () => null
    })
    await page.goto(site.address)
    await mounted(page)
    await page.mouse.move(10, 10)
    await page.getByText('This browser cannot show the face').waitFor()
    expect(contrast(await faceOf(page))).toBeGreaterThan(100)
    await page.context().close()
  })

  it('shows its text and the still image without JavaScript', async () => {
    await withPage('', { viewport: DESKTOP, javaScriptEnabled: false }, async (page) => {
      expect(await page.locator('h1').innerText()).toContain('Wrinkles')
      expect(contrast(await faceOf(page))).toBeGreaterThan(100)
    })
  })
})

describe('the pages', () => {
  it('run an example next to its source', async () => {
    await withPage('examples/minimal.html', { viewport: DESKTOP }, async (page) => {
      expect(await page.locator('.language-html').innerText()).toContain('extendLoader')
      const canvas = page.frameLocator('.live iframe').locator('canvas')
      await canvas.waitFor()
      await expect.poll(async () => contrast(await pixelsOf(await canvas.screenshot()))).toBeGreaterThan(100)
    })
  })

  it('list the examples with pictures, filter them, and open one by keyboard', async () => {
    await withPage('examples/', { viewport: DESKTOP }, async (page) => {
      await mounted(page)
      const cards = page.locator('.cards a')
      expect(await cards.count()).toBe(exampleNames().length)
      await page.getByLabel('Filter').fill('compressed cloth')
      await expect.poll(() => cards.count()).toBe(1)
      const width = () => cards.locator('img').evaluate((image: HTMLImageElement) => image.naturalWidth)
      await expect.poll(width).toBe(480)
      await page.keyboard.press('Tab')
      await page.keyboard.press('Enter')
      await page.waitForURL(/examples\/tension\.html$/)
    })
  })

  it('have a search that finds a word', async () => {
    await withPage('docs/guide.html', { viewport: DESKTOP }, async (page) => {
      await page.getByRole('button', { name: 'Search' }).click()
      await page.locator('input[type=search]').fill('haemoglobin')
      await page.locator('.VPLocalSearchBox .result').first().click()
      await page.waitForURL((url) => !url.pathname.endsWith('/docs/guide.html'))
      expect(page.url()).toContain(site.address)
    })
  })

  it('start and cancel the benchmark', async () => {
    await withPage('bench/', { viewport: DESKTOP }, async (page) => {
      const run = page.getByRole('button', { name: 'Run the benchmark here' })
      await run.click()
      await expect
        .poll(() => page.locator('.benchmark progress').evaluate((bar: HTMLProgressElement) => bar.value), {
          timeout: 240_000,
        })
        .toBeGreaterThan(0)
      expect(await run.isDisabled()).toBe(true)
      await page.getByRole('button', { name: 'Cancel' }).click()
      await expect.poll(() => run.isEnabled()).toBe(true)
      expect(await page.locator('.benchmark [role=status]').innerText()).toBe('')
    })
  })

  it('open the studio', async () => {
    // In a narrower window, the link is in a menu.
    const viewport = { width: 1280, height: 640 }
    await withPage('docs/guide.html', { viewport }, async (page) => {
      const navigation = page.getByRole('navigation', { name: 'Main Navigation' })
      await navigation.getByRole('link', { name: 'Studio', exact: true }).click()
      await page.getByRole('heading', { name: 'Drop your avatar' }).waitFor()
      expect(page.url()).toBe(`${site.address}studio/index.html`)
    })
  })
})

async function pixelsOf(picture: Buffer): Promise<CanvasPixels> {
  const { data, info } = await sharp(picture).removeAlpha().raw().toBuffer({ resolveWithObject: true })
  return { width: info.width, height: info.height, data }
}
