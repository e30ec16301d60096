import { readdirSync } from 'node:fs'
import { mkdir, readFile } from 'node:fs/promises'
import type { Browser, Page, Route } from 'playwright-core'
import sharp from 'sharp'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { editGlb } from '../glb.ts'
import { openBrowser, openPage } from './browser.ts'
import {
  drawSettled,
  firstPicture,
  openPaused,
  playSurprise,
  readNextFrame,
  resize,
  SECOND,
  switchOff,
} from './paused-page.ts'
import { contrast, largestDifference, meanDifference, type Region, WHOLE } from './pixels.ts'
import { type CanvasPixels, readCanvas } from './read-canvas.ts'
import { startStaticServer } from './static-server.ts'

const EXAMPLES = readdirSync(new URL('../../examples/', import.meta.url)).filter((name) =>
  name.endsWith('.html'),
)

/** Folder where the pictures are saved for inspection. */
const OUTPUT = new URL('../output/examples/', import.meta.url)

/** The forehead of the shipped face in the examples' framing. */
const FOREHEAD: Region = { left: 0.4, top: 0.14, right: 0.6, bottom: 0.36 }

/** Blendshape weights for normals.html. */
const CHEEKS_PUFFED = 'cheekPuff=1&mouthPucker=0.7'

const PHONE = { width: 390, height: 844 }

/** Large enough for one face; a crowd needs more. */
const SIZE = { width: 400, height: 300 }
const CROWD_SIZE = { width: 800, height: 600 }

let browser: Browser
let server: Awaited<ReturnType<typeof startStaticServer>>

beforeAll(async () => {
  browser = await openBrowser()
  server = await startStaticServer()
  await mkdir(OUTPUT, { recursive: true })
})

afterAll(async () => {
  await browser?.close()
  server?.close()
})

test('there are examples', () => expect(EXAMPLES).toContain('minimal.html'))

test('the page of the README has at most 25 lines', async () => {
  const page = await readFile(new URL('../../examples/minimal.html', import.meta.url), 'utf8')
  expect(page.trimEnd().split('\n').length).toBeLessThanOrEqual(25)
})

/** Examples of one face that is repeatedly surprised. */
const PORTRAITS = ['minimal.html', 'webgpu.html']

/** Examples of drivers: queries with and without wrinkles, and the region where they appear. Left is the person's right. */
const DRIVERS: readonly (readonly [page: string, driven: string, atRest: string, region: Region])[] = [
  ['age.html', '?age=75', '?age=20', { left: 0.4, top: 0.1, right: 0.6, bottom: 0.3 }],
  ['expressions.html', '?happy=0.7&surprised=0.6', '', { left: 0.4, top: 0.1, right: 0.6, bottom: 0.3 }],
  ['inputs.html', '?stress=100', '?stress=0', { left: 0.4, top: 0.1, right: 0.6, bottom: 0.3 }],
  ['joints.html', '?fist=1', '?fist=0', { left: 0.4, top: 0.45, right: 0.6, bottom: 0.95 }],
  [
    'joints.html',
    '?model=neck&turn=1',
    '?model=neck&turn=0',
    { left: 0.5, top: 0.55, right: 0.65, bottom: 0.75 },
  ],
  ['key-frames.html', '?time=2.2', '?time=0', { left: 0.4, top: 0.1, right: 0.6, bottom: 0.3 }],
  [
    'muscles.html',
    '?expression=surprise',
    '?expression=neutral',
    { left: 0.4, top: 0.1, right: 0.6, bottom: 0.3 },
  ],
  ['vrm.html', '?happy=1&blink=1', '', { left: 0.25, top: 0.3, right: 0.75, bottom: 0.7 }],
  ['tension.html', '?push=0.3', '?push=0', { left: 0.4, top: 0.3, right: 0.6, bottom: 0.8 }],
]

test('every example is opened', () => {
  const others = ['auto.html', 'crowd.html', 'normals.html']
  const opened = new Set([...PORTRAITS, ...DRIVERS.map(([page]) => page), ...others])
  expect([...opened].sort()).toEqual([...EXAMPLES].sort())
})

test.each(DRIVERS)('%s%s wrinkles', async (name, driven, atRest, region) => {
  const { wrinkled, still, off } = await shootOnAndOff(`${name}${driven}`)
  await save(wrinkled, `${name}${driven}`)
  expect(contrast(wrinkled)).toBeGreaterThan(100)
  expect(largestDifference(wrinkled, await shoot(`${name}${atRest}`), region)).toBeGreaterThan(20)
  // The cloth keeps moving.
  if (name === 'tension.html') return
  // Only the wrinkles change between frames.
  expect(largestDifference(wrinkled, still, WHOLE)).toBe(0)
  expect(largestDifference(wrinkled, off, region)).toBeGreaterThan(20)
})

test('an expression that blocks the blink also blocks its wrinkles', async () => {
  const both = await shoot('vrm.html?happy=1&blink=1')
  expect(largestDifference(both, await shoot('vrm.html?happy=1'), WHOLE)).toBe(0)
  expect(largestDifference(both, await shoot('vrm.html?blink=1'), WHOLE)).toBeGreaterThan(20)
})

test('a list of scores moves the face like the same blendshapes', async () => {
  const scored = await shoot('expressions.html?scores')
  const played = await shoot('expressions.html?surprised=1')
  const rest = await shoot('expressions.html')
  const forehead = DRIVERS.find(([page]) => page === 'expressions.html')![3]
  expect(largestDifference(scored, rest, forehead)).toBeGreaterThan(20)
  expect(largestDifference(scored, played, forehead)).toBeLessThan(largestDifference(scored, rest, forehead))
})

test('normals.html lights the cheeks with the normals of their blendshapes', async () => {
  const [none, baked, recomputed] = [
    await shoot(`normals.html?remedy=none&${CHEEKS_PUFFED}`),
    await shoot(`normals.html?remedy=baked&${CHEEKS_PUFFED}`),
    await shoot(`normals.html?remedy=recomputed&${CHEEKS_PUFFED}`),
  ]
  await save(recomputed, 'normals.html')
  const cheeks = { left: 0.38, top: 0.35, right: 0.62, bottom: 0.6 }
  // The shading is wrong by far more than noise and antialiasing ...
  expect(largestDifference(none, recomputed, cheeks)).toBeGreaterThan(40)
  // ... and the remedies differ from each other by less than a sixth of that: baked normals of two targets are summed, and only the
  // other remedy rotates tangents.
  expect(meanDifference(baked, recomputed, cheeks)).toBeLessThan(meanDifference(none, recomputed, cheeks) / 6)
})

test.each([
  ...new Map(DRIVERS.map(([page, driven]) => [page, `${page}${driven}`])).values(),
  `normals.html?remedy=none&${CHEEKS_PUFFED}`,
])('%s fits a phone', async (name) => {
  await shoot(name)
  expect(widthsOnPhone.get(name)).toBeLessThanOrEqual(PHONE.width)
})

test('auto.html makes wrinkles while the face is shown, and takes its bar away', async () => {
  const { page, complaints } = await openPage(browser, { viewport: PHONE })
  await openPaused(page, `${server.origin}/examples/auto.html`)
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(PHONE.width)
  await resize(page, SIZE)
  await firstPicture(page)
  await page.locator('progress').waitFor({ state: 'detached', timeout: 0 })
  // They have faded in.
  await page.clock.runFor(2 * SECOND)
  const wrinkled = await readNextFrame(page)
  await save(wrinkled, 'auto.html')
  await switchOff(page)
  const forehead = DRIVERS.find(([name]) => name === 'expressions.html')![3]
  expect(largestDifference(wrinkled, await readNextFrame(page), forehead)).toBeGreaterThan(20)
  expect(complaints).toEqual([])
  await page.close()
})

test.each(PORTRAITS)('%s shows a face with a creasing forehead', async (name) => {
  const wrinkled = await shoot(name)
  const smooth = await shoot(name, 'flat')
  await save(wrinkled, name)
  expect(contrast(wrinkled)).toBeGreaterThan(100)
  expect(largestDifference(wrinkled, smooth, FOREHEAD)).toBeGreaterThan(20)
})

test('crowd.html shows faces that wrinkle independently', async () => {
  const wrinkled = await shoot('crowd.html?count=6')
  const smooth = await shoot('crowd.html?count=6', 'flat')
  await save(wrinkled, 'crowd.html')
  expect(contrast(wrinkled)).toBeGreaterThan(100)
  // Four of the six faces wrinkle at any time, in some of the columns.
  const columns = [0, 1, 2, 3].map((i) => ({ left: i / 4, top: 0, right: (i + 1) / 4, bottom: 1 }))
  expect(
    columns.filter((column) => largestDifference(wrinkled, smooth, column) > 20).length,
  ).toBeGreaterThanOrEqual(2)
})

/** Sets the normal scale of a file's wrinkles to 0. */
function flatten(json: {
  materials: { extensions?: Record<string, { layers?: { normalTexture: object }[] }> }[]
}): void {
  for (const { extensions } of json.materials) {
    for (const layer of extensions?.FURROW_wrinkle_maps?.layers ?? [])
      Object.assign(layer.normalTexture, { scale: 0 })
  }
}

/** Pictures drawn so far, and the widths of pages with controls on a phone. */
const shots = new Map<string, Promise<CanvasPixels>>()
const widthsOnPhone = new Map<string, number>()

/** Picture of an example at the moment of surprise, drawn once; `flat`: with wrinkles without slope. */
function shoot(name: string, form: 'wrinkled' | 'flat' = 'wrinkled'): Promise<CanvasPixels> {
  const key = `${name} ${form}`
  const shot = shots.get(key) ?? withExample(name, form, readCanvas)
  shots.set(key, shot)
  return shot
}

/** Pictures of an example with wrinkles, in the next frame, and with wrinkles switched off in the frame after. */
async function shootOnAndOff(name: string) {
  return withExample(name, 'wrinkled', async (page) => {
    const wrinkled = await readCanvas(page)
    shots.set(`${name} wrinkled`, Promise.resolve(wrinkled))
    const still = await readNextFrame(page)
    await switchOff(page)
    return { wrinkled, still, off: await readNextFrame(page) }
  })
}

/** Opens an example and advances it to the moment of surprise; the page must report no errors or warnings. */
async function withExample<T>(
  name: string,
  form: 'wrinkled' | 'flat',
  inspect: (page: Page) => Promise<T>,
): Promise<T> {
  const hasControls = ![...PORTRAITS, 'crowd.html'].some((page) => name.startsWith(page))
  const size = name.startsWith('crowd.html') ? CROWD_SIZE : SIZE
  const { page, complaints } = await openPage(browser, { viewport: hasControls ? PHONE : size })
  page.on('console', (message) => {
    const text = message.text()
    // Performance messages of the driver are not the page's.
    if (message.type() === 'warning' && !text.includes('GL Driver Message')) complaints.push(text)
  })
  try {
    if (form === 'flat') await page.route('**/faces/*.glb', fulfillFlattened)
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

async function fulfillFlattened(route: Route): Promise<void> {
  const file = new URL(`../..${new URL(route.request().url()).pathname}`, import.meta.url)
  const body = Buffer.from(editGlb(await readFile(file), flatten))
  await route.fulfill({ contentType: 'model/gltf-binary', body })
}

async function save({ width, height, data }: CanvasPixels, name: string): Promise<void> {
  const file = new URL(`${name.replace('.html', '').replace(/[?&]/g, '-')}.png`, OUTPUT).pathname
  await sharp(data, { raw: { width, height, channels: 3 } }).toFile(file)
}
