import { readdirSync } from 'node:fs'
import { mkdir, readFile } from 'node:fs/promises'
import type { Browser, Page, Route } from 'playwright-core'
import sharp from 'sharp'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { editGlb } from '../glb.ts'
import { openBrowser, openPage } from './browser.ts'
import { contrast, largestDifference, meanDifference, type Region } from './pixels.ts'
import { type CanvasPixels, makeCanvasReadable, readCanvas } from './read-canvas.ts'
import { startStaticServer } from './static-server.ts'

const EXAMPLES = readdirSync(new URL('../../examples/', import.meta.url)).filter((name) =>
  name.endsWith('.html'),
)

/** All of a picture. */
const WHOLE: Region = { left: 0, top: 0, right: 1, bottom: 1 }

/** Where the pictures are kept to be looked at. */
const OUTPUT = new URL('../output/examples/', import.meta.url)

/** The forehead of the face that ships, as all examples frame it. */
const FOREHEAD: Region = { left: 0.4, top: 0.14, right: 0.6, bottom: 0.36 }

/** What normals.html shows its remedies with. */
const CHEEKS_PUFFED = 'cheekPuff=1&mouthPucker=0.7'

const PHONE = { width: 390, height: 844 }

/** A face that fills the picture needs no more; those of a crowd do. */
const SIZE = { width: 400, height: 300 }
const CROWD_SIZE = { width: 800, height: 600 }

const SECOND = 1000

/** Milliseconds after which each example's face starts to be surprised; it stays so as long again. */
const LEAD = 1.5 * SECOND

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

/** Examples of one face that is surprised again and again. */
const PORTRAITS = ['minimal.html', 'webgpu.html']

/**
 * Examples of drivers: what makes them wrinkle, and where on the picture. Left is the person's right.
 */
const DRIVERS: readonly (readonly [page: string, driven: string, atRest: string, where: Region])[] = [
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
  const opened = new Set([...PORTRAITS, ...DRIVERS.map(([page]) => page), 'crowd.html', 'normals.html'])
  expect([...opened].sort()).toEqual([...EXAMPLES].sort())
})

test.each(DRIVERS)('%s%s wrinkles', async (name, driven, atRest, where) => {
  const { wrinkled, still, off } = await shootBothWays(`${name}${driven}`)
  await keep(wrinkled, `${name}${driven}`)
  expect(contrast(wrinkled)).toBeGreaterThan(100)
  expect(largestDifference(wrinkled, await shoot(`${name}${atRest}`), where)).toBeGreaterThan(20)
  // The cloth goes on moving.
  if (name === 'tension.html') return
  // Nothing but the wrinkles changes from one frame to the next.
  expect(largestDifference(wrinkled, still, WHOLE)).toBe(0)
  expect(largestDifference(wrinkled, off, where)).toBeGreaterThan(20)
})

test('an expression that blocks the blink keeps its wrinkles away too', async () => {
  const both = await shoot('vrm.html?happy=1&blink=1')
  expect(largestDifference(both, await shoot('vrm.html?happy=1'), WHOLE)).toBe(0)
  expect(largestDifference(both, await shoot('vrm.html?blink=1'), WHOLE)).toBeGreaterThan(20)
})

test('a list of scores moves the face as the same blendshapes do', async () => {
  const scored = await shoot('expressions.html?scores')
  const played = await shoot('expressions.html?surprised=1')
  const rest = await shoot('expressions.html')
  const forehead = DRIVERS.find(([page]) => page === 'expressions.html')![3]
  expect(largestDifference(scored, rest, forehead)).toBeGreaterThan(20)
  expect(largestDifference(scored, played, forehead)).toBeLessThan(largestDifference(scored, rest, forehead))
})

test('normals.html lights cheeks by the normals that their blendshapes need', async () => {
  const [none, baked, recomputed] = [
    await shoot(`normals.html?remedy=none&${CHEEKS_PUFFED}`),
    await shoot(`normals.html?remedy=baked&${CHEEKS_PUFFED}`),
    await shoot(`normals.html?remedy=recomputed&${CHEEKS_PUFFED}`),
  ]
  await keep(recomputed, 'normals.html')
  const cheeks = { left: 0.38, top: 0.35, right: 0.62, bottom: 0.6 }
  // Their shade is off by far more than what grain and antialiasing come to ...
  expect(largestDifference(none, recomputed, cheeks)).toBeGreaterThan(40)
  // ... and what is left between the remedies is less than a sixth: the sum of two targets' normals, and the tangents, that only one
  // of them turns.
  expect(meanDifference(baked, recomputed, cheeks)).toBeLessThan(meanDifference(none, recomputed, cheeks) / 6)
})

test.each([
  ...new Map(DRIVERS.map(([page, driven]) => [page, `${page}${driven}`])).values(),
  `normals.html?remedy=none&${CHEEKS_PUFFED}`,
])('%s fits a phone', async (name) => {
  await shoot(name)
  expect(widthsOnPhone.get(name)).toBeLessThanOrEqual(PHONE.width)
})

test.each(PORTRAITS)('%s shows a face whose forehead creases', async (name) => {
  const wrinkled = await shoot(name)
  const smooth = await shoot(name, 'flat')
  await keep(wrinkled, name)
  expect(contrast(wrinkled)).toBeGreaterThan(100)
  expect(largestDifference(wrinkled, smooth, FOREHEAD)).toBeGreaterThan(20)
})

test('crowd.html shows faces that wrinkle each by itself', async () => {
  const wrinkled = await shoot('crowd.html?count=6')
  const smooth = await shoot('crowd.html?count=6', 'flat')
  await keep(wrinkled, 'crowd.html')
  expect(contrast(wrinkled)).toBeGreaterThan(100)
  // Some of the six in their columns, of which four wrinkle at any time.
  const columns = [0, 1, 2, 3].map((i) => ({ left: i / 4, top: 0, right: (i + 1) / 4, bottom: 1 }))
  expect(
    columns.filter((column) => largestDifference(wrinkled, smooth, column) > 20).length,
  ).toBeGreaterThanOrEqual(2)
})

/** Takes the slope out of the wrinkles that a file carries. */
function flatten(json: {
  materials: { extensions?: Record<string, { layers?: { normalTexture: object }[] }> }[]
}): void {
  for (const { extensions } of json.materials) {
    for (const layer of extensions?.FURROW_wrinkle_maps?.layers ?? [])
      Object.assign(layer.normalTexture, { scale: 0 })
  }
}

/** Pictures that were drawn already, and how wide pages with controls were on a phone. */
const shots = new Map<string, Promise<CanvasPixels>>()
const widthsOnPhone = new Map<string, number>()

/** The example at the moment of surprise; `flat`: with wrinkles that have no slope. Each is drawn once. */
function shoot(name: string, form: 'wrinkled' | 'flat' = 'wrinkled'): Promise<CanvasPixels> {
  const key = `${name} ${form}`
  const shot = shots.get(key) ?? withExample(name, form, readCanvas)
  shots.set(key, shot)
  return shot
}

/** The example with its wrinkles, a frame later once more, and with wrinkles switched off in the next. */
async function shootBothWays(name: string) {
  return withExample(name, 'wrinkled', async (page) => {
    const nextFrame = async () => {
      await page.clock.runFor(SECOND / 30)
      return readCanvas(page)
    }
    const wrinkled = await readCanvas(page)
    shots.set(`${name} wrinkled`, Promise.resolve(wrinkled))
    const still = await nextFrame()
    await page.evaluate(SWITCH_OFF)
    return { wrinkled, still, off: await nextFrame() }
  })
}

/** For a page, whose import map tells what these modules are: from the next frame on, no mesh shows wrinkles. */
const SWITCH_OFF = `
  Promise.all([import('three'), import('furrow/three')]).then(([{ Scene }, { wrinklesOf }]) => {
    Scene.prototype.onBeforeRender = (_, scene) =>
      scene.traverse((object) => {
        const wrinkles = wrinklesOf(object)
        if (wrinkles) wrinkles.mode = 'off'
      })
  })`

/** Opens an example and brings it to the moment of surprise; the page may not complain. */
async function withExample<T>(
  name: string,
  form: 'wrinkled' | 'flat',
  look: (page: Page) => Promise<T>,
): Promise<T> {
  const hasControls = ![...PORTRAITS, 'crowd.html'].some((page) => name.startsWith(page))
  const size = name.startsWith('crowd.html') ? CROWD_SIZE : SIZE
  const { page, complaints } = await openPage(browser, { viewport: hasControls ? PHONE : size })
  page.on('console', (message) => {
    const text = message.text()
    // What the driver says of its speed is not the page's doing.
    if (message.type() === 'warning' && !text.includes('GL Driver Message')) complaints.push(text)
  })
  try {
    await makeCanvasReadable(page)
    if (form === 'flat') await page.route('**/faces/*.glb', fulfillFlattened)
    await page.clock.install({ time: 0 })
    await page.clock.pauseAt(SECOND)
    await page.goto(`${server.origin}/examples/${name}`)
    // The page adds it once the face is there; as time stands still, nothing is drawn yet.
    await page.waitForSelector('canvas')
    if (hasControls) {
      widthsOnPhone.set(name, await page.evaluate(() => document.documentElement.scrollWidth))
      await page.setViewportSize(size)
    }
    await firstPicture(page)
    // Two leaps with a frame each: the surprise begins, and has arrived.
    await page.clock.fastForward(LEAD + SECOND / 10)
    await page.clock.fastForward(SECOND / 2)
    const seen = await look(page)
    expect(complaints).toEqual([])
    return seen
  } finally {
    await page.close()
  }
}

async function fulfillFlattened(route: Route): Promise<void> {
  const file = new URL(`../..${new URL(route.request().url()).pathname}`, import.meta.url)
  const body = Buffer.from(editGlb(await readFile(file), flatten))
  await route.fulfill({ contentType: 'model/gltf-binary', body })
}

/** Time stands still in the page but for these steps, so that every run draws the same picture. */
async function firstPicture(page: Page): Promise<void> {
  for (;;) {
    await page.clock.runFor(SECOND / 60)
    if (contrast(await readCanvas(page)) > 0) return
    // A renderer may still be making itself ready; its own time must not run away meanwhile.
    await page.waitForTimeout(SECOND / 4)
  }
}

async function keep({ width, height, data }: CanvasPixels, name: string): Promise<void> {
  const file = new URL(`${name.replace('.html', '').replace(/[?&]/g, '-')}.png`, OUTPUT).pathname
  await sharp(data, { raw: { width, height, channels: 3 } }).toFile(file)
}
