import { mkdir } from 'node:fs/promises'
import type { Page } from 'playwright-core'
import sharp from 'sharp'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { openPage, useBrowser } from './browser.ts'
import { BROWS, CHEEKS_PUFFED, type Controls, DRIVERS, EXAMPLES, FOREHEAD, PORTRAITS } from './examples.ts'
import {
  drawSettled,
  firstPicture,
  openPaused,
  playSurprise,
  readNextFrame,
  resize,
  SECOND,
  switchWrinkles,
} from './paused-page.ts'
import { contrast, largestDifference, meanDifference, type Region, WHOLE } from './pixels.ts'
import { type CanvasPixels, readCanvas } from './read-canvas.ts'
import { startStaticServer } from './static-server.ts'

/** Folder for the pictures, for inspection. */
const OUTPUT = new URL('../output/examples/', import.meta.url)

const PHONE = { width: 390, height: 844 }

/** Large enough for one face. A crowd needs more. */
const SIZE = { width: 400, height: 300 }
const CROWD_SIZE = { width: 800, height: 600 }

const browser = useBrowser()
let server: Awaited<ReturnType<typeof startStaticServer>>

beforeAll(async () => {
  server = await startStaticServer()
  await mkdir(OUTPUT, { recursive: true })
})

afterAll(async () => {
  server?.close()
})

test('examples exist', () => expect(EXAMPLES).toContain('minimal.html'))

test('every example is opened', () => {
  const others = ['auto.html', 'crowd.html', 'inspector.html', 'normals.html', 'tension.html', 'vrm.html']
  const opened = new Set([...PORTRAITS, ...DRIVERS.map(([page]) => page), ...others])
  expect([...opened].sort()).toEqual([...EXAMPLES].sort())
})

test.each(DRIVERS)('%s%s wrinkles, and its controls smooth it', (name, driven, atRest, region) =>
  withExample(`${name}${driven}`, async (page) => {
    const wrinkled = await readWrinkled(page, `${name}${driven}`)
    // Only wrinkles change between frames.
    expect(largestDifference(wrinkled, await readNextFrame(page), WHOLE)).toBe(0)
    await expectSmoothed(page, wrinkled, atRest, region)
  }),
)

test('tension.html?push=0.3 wrinkles, and its controls smooth it', () =>
  withExample('tension.html?push=0.3', async (page) => {
    const pushed = await readWrinkled(page, 'tension.html?push=0.3')
    await expectSmoothed(page, pushed, { push: 0 }, { left: 0.4, top: 0.3, right: 0.6, bottom: 0.8 })
  }))

test("vrm.html?happy=1&blink=1 wrinkles, its controls smooth it, and an expression that blocks the blink also blocks the blink's wrinkles", () =>
  withExample('vrm.html?happy=1&blink=1', async (page) => {
    const both = await readWrinkled(page, 'vrm.html?happy=1&blink=1')
    expect(largestDifference(both, await setControls(page, { blink: 0 }), WHOLE)).toBe(0)
    const blinking = await setControls(page, { happy: 0, blink: 1 })
    expect(largestDifference(both, blinking, WHOLE)).toBeGreaterThan(20)
    expect(largestDifference(both, await setControls(page, { happy: 1 }), WHOLE)).toBe(0)
    const region = { left: 0.25, top: 0.3, right: 0.75, bottom: 0.7 }
    await expectSmoothed(page, both, { happy: 0, blink: 0 }, region)
  }))

test('a list of scores moves the face like the same blendshapes', async () => {
  const scored = await shoot('expressions.html?scores')
  const [rest, played] = await withExample('expressions.html', async (page) => [
    await readCanvas(page),
    await setControls(page, { surprised: 1 }),
  ])
  expect(largestDifference(scored, rest, BROWS)).toBeGreaterThan(20)
  expect(largestDifference(scored, played, BROWS)).toBeLessThan(largestDifference(scored, rest, BROWS))
})

test('normals.html lights the cheeks with the normals of their blendshapes', () =>
  withExample(`normals.html?remedy=none&${CHEEKS_PUFFED}`, async (page) => {
    const none = await readCanvas(page)
    const baked = await setControls(page, { baked: true })
    const recomputed = await setControls(page, { recomputed: true })
    await save(recomputed, 'normals.html')
    const cheeks = { left: 0.38, top: 0.35, right: 0.62, bottom: 0.6 }
    // Wrong shading differs by far more than noise and antialiasing.
    expect(largestDifference(none, recomputed, cheeks)).toBeGreaterThan(40)
    // The remedies differ by less than a sixth of that: baked normals of two targets are summed, and only recomputing rotates tangents.
    expect(meanDifference(baked, recomputed, cheeks)).toBeLessThan(
      meanDifference(none, recomputed, cheeks) / 6,
    )
  }))

test.each([
  ...new Map(DRIVERS.map(([page, driven]) => [page, `${page}${driven}`])).values(),
  `normals.html?remedy=none&${CHEEKS_PUFFED}`,
  'tension.html?push=0.3',
  'vrm.html?happy=1&blink=1',
])('%s fits a phone', async (name) => {
  if (!widthsOnPhone.has(name)) await shoot(name)
  expect(widthsOnPhone.get(name)).toBeLessThanOrEqual(PHONE.width)
})

// `examples-auto.test.ts` checks that auto.html makes wrinkles and removes its bar.
test('auto.html shows the face and its progress bar while it makes wrinkles', async () => {
  const { page, complaints } = await openPage(browser(), { viewport: PHONE })
  // Delays the wrinkles until the bar is seen, however slowly the page draws.
  let mayWork = () => {}
  const seen = new Promise<void>((resolve) => {
    mayWork = resolve
  })
  await page.route('**/auto-worker.js', (route) => seen.then(() => route.continue()))
  await openPaused(page, `${server.origin}/examples/auto.html`)
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(PHONE.width)
  await firstPicture(page)
  expect(await page.locator('progress').count()).toBe(1)
  const working = page.waitForResponse('**/auto-worker.js')
  mayWork()
  await working
  expect(complaints).toEqual([])
  await page.close()
})

test.each(PORTRAITS)('%s shows a face with a creasing forehead', async (name) => {
  const [wrinkled, smooth] = await shootOnAndOff(name)
  expect(largestDifference(wrinkled, smooth, FOREHEAD)).toBeGreaterThan(20)
})

test('crowd.html shows faces that wrinkle independently', async () => {
  const [wrinkled, smooth] = await shootOnAndOff('crowd.html?count=6')
  // At any time four of the six faces wrinkle, in some of the columns.
  const columns = [0, 1, 2, 3].map((i) => ({ left: i / 4, top: 0, right: (i + 1) / 4, bottom: 1 }))
  expect(
    columns.filter((column) => largestDifference(wrinkled, smooth, column) > 20).length,
  ).toBeGreaterThanOrEqual(2)
})

/** Page widths on a phone, for pages with controls. */
const widthsOnPhone = new Map<string, number>()

/** Takes a picture of an example at the moment of surprise. */
function shoot(name: string): Promise<CanvasPixels> {
  return withExample(name, readCanvas)
}

/** Takes a picture at the moment of surprise, and one two frames later without wrinkles. */
function shootOnAndOff(name: string): Promise<CanvasPixels[]> {
  return withExample(name, async (page) => {
    const wrinkled = await readWrinkled(page, name)
    await switchWrinkles(page, 'off')
    return [wrinkled, await readNextFrame(page)]
  })
}

/** Reads and saves the picture of an example, which must not be blank. */
async function readWrinkled(page: Page, name: string): Promise<CanvasPixels> {
  const wrinkled = await readCanvas(page)
  await save(wrinkled, name)
  expect(contrast(wrinkled)).toBeGreaterThan(100)
  return wrinkled
}

/** Expects a region to change if wrinkles are off or controls are at rest. */
async function expectSmoothed(
  page: Page,
  wrinkled: CanvasPixels,
  atRest: Controls,
  region: Region,
): Promise<void> {
  await switchWrinkles(page, 'off')
  expect(largestDifference(wrinkled, await readNextFrame(page), region)).toBeGreaterThan(20)
  await switchWrinkles(page, 'default')
  expect(largestDifference(wrinkled, await setControls(page, atRest), region)).toBeGreaterThan(20)
}

/** Opens an example and advances it to the moment of surprise. The page must report no errors or warnings. */
async function withExample<T>(name: string, inspect: (page: Page) => Promise<T>): Promise<T> {
  const hasControls = ![...PORTRAITS, 'crowd.html'].some((page) => name.startsWith(page))
  const size = name.startsWith('crowd.html') ? CROWD_SIZE : SIZE
  const { page, complaints } = await openPage(browser(), { viewport: hasControls ? PHONE : size })
  page.on('console', (message) => {
    const text = message.text()
    // Driver performance messages do not come from the page.
    if (message.type() === 'warning' && !text.includes('GL Driver Message')) complaints.push(text)
  })
  try {
    await openPaused(page, `${server.origin}/examples/${name}`)
    if (hasControls) {
      widthsOnPhone.set(name, await page.evaluate(() => document.documentElement.scrollWidth))
      await resize(page, size)
    }
    await playSurprise(page)
    if (hasControls) await drawSettled(page)
    const result = await inspect(page)
    expect(complaints).toEqual([])
    return result
  } finally {
    await page.close()
  }
}

/** Sets controls of an example. Returns its picture after all effects have ended. */
async function setControls(page: Page, controls: Controls): Promise<CanvasPixels> {
  for (const [name, value] of Object.entries(controls)) {
    if (value === true) await page.getByText(name, { exact: true }).dispatchEvent('click')
    else await page.getByLabel(name).fill(String(value))
  }
  await page.clock.runFor(SECOND / 60)
  await page.clock.fastForward(60 * SECOND)
  return readNextFrame(page)
}

async function save({ width, height, data }: CanvasPixels, name: string): Promise<void> {
  const file = new URL(`${name.replace('.html', '').replace(/[?&]/g, '-')}.png`, OUTPUT).pathname
  await sharp(data, { raw: { width, height, channels: 3 } }).toFile(file)
}
