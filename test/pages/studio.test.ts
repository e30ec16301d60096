import { fileURLToPath } from 'node:url'
import type { Browser, Page } from 'playwright-core'
import sharp from 'sharp'
import { createServer, type ViteDevServer } from 'vite'
import { afterAll, afterEach, beforeAll, describe, expect, test } from 'vitest'
import { openBrowser, openPage } from './browser.ts'
import {
  black,
  difference,
  dismiss,
  drop,
  expectValue,
  face,
  ready,
  slider,
  spread,
  valuesOnTheWay,
} from './studio-page.ts'

const DESKTOP = { width: 800, height: 400 }
const PHONE = { width: 390, height: 844 }

let server: ViteDevServer
let address: string
let browser: Browser

beforeAll(async () => {
  server = await createServer({
    configFile: fileURLToPath(new URL('../../studio/vite.config.ts', import.meta.url)),
    logLevel: 'error',
    // Files that change while the test runs must not reload the page under it.
    server: { port: 0, host: '127.0.0.1', hmr: false, watch: null },
  })
  await server.listen()
  address = `http://127.0.0.1:${(server.httpServer!.address() as { port: number }).port}/`
  browser = await openBrowser()
})

afterAll(async () => {
  await browser?.close()
  await server?.close()
})

const studio = openStudio()

describe('the studio on WebGL', () => {
  test('shows the face, and every way of looking at it', () => showsLooks(studio.page, 'WebGL 2'))

  test('moves the face by expressions and sliders', () => movesFace(studio.page))

  test('goes from one expression to the next in steps, unless motion is to be reduced', async () => {
    const { page } = studio
    await page.emulateMedia({ reducedMotion: 'no-preference' })
    expect((await valuesOnTheWay(page, 'Angry', 'glabella')).length).toBeGreaterThan(2)
    await page.emulateMedia({ reducedMotion: 'reduce' })
    expect(await valuesOnTheWay(page, 'Surprised', 'glabella')).toEqual([0])
    await expectValue(slider(page, 'foreheadLeft'), 1)
  })

  test('pointing at an area shows what drives it, and at a blendshape the areas it drives', async () => {
    const { page } = studio
    await page.getByRole('button', { name: 'Happy' }).click()
    await expectValue(slider(page, 'mouthSmileLeft'), 0.85)
    const before = await face(page)
    await page.locator('#areas label', { hasText: 'crowsFeetLeft' }).hover()
    const explanation = page.locator('.explanation')
    expect(await explanation.innerText()).toContain('1.00 of crowsFeetLeft from')
    expect(await explanation.innerText()).toContain('0.64 by cheekSquintLeft')
    const linked = () => page.locator('.row.linked label').allTextContents()
    expect((await linked()).sort()).toEqual([
      'cheekSquintLeft',
      'eyeBlinkLeft',
      'eyeSquintLeft',
      'mouthSmileLeft',
    ])
    // The area itself, on the face.
    expect(await difference(before, await face(page))).toBeGreaterThan(2)
    await page.locator('#filter').fill('mouthSmileLeft')
    await page.locator('#targets label', { hasText: 'mouthSmileLeft' }).hover()
    expect((await linked()).sort()).toEqual(['crowsFeetLeft', 'nasolabialLeft', 'underEyeLeft'])
    expect(await explanation.isVisible()).toBe(false)
    await page.locator('#filter').fill('')
    await page.locator('#filter').hover()
    expect(await linked()).toEqual([])
    expect(await difference(before, await face(page))).toBeLessThan(0.5)
    await page.getByRole('button', { name: 'Surprised' }).click()
    await expectValue(slider(page, 'foreheadLeft'), 1)
  })

  test('the divider moves by keys and by pointer', async () => {
    const { page } = studio
    const divider = page.getByRole('slider', { name: /^Divider/ })
    const middle = await face(page)
    await divider.press('End')
    expect(await divider.getAttribute('aria-valuenow')).toBe('100')
    const without = await face(page)
    await divider.press('Home')
    const wrinkled = await face(page)
    expect(await difference(without, wrinkled)).toBeGreaterThan(0.05)
    expect(await difference(middle, without)).toBeGreaterThan(0.01)
    expect(await difference(middle, wrinkled)).toBeGreaterThan(0.01)
    await divider.press('ArrowRight')
    expect(await divider.getAttribute('aria-valuenow')).toBe('2')
    const { x, y, width, height } = (await divider.boundingBox())!
    await page.mouse.move(x + width / 2, y + height / 2)
    await page.mouse.down()
    await page.mouse.move(x + width / 2 + 200, y + height / 2)
    await page.mouse.up()
    expect(Number(await divider.getAttribute('aria-valuenow'))).toBeGreaterThan(20)
  })

  test('a dropped image becomes an area, which can be removed', async () => {
    const { page } = studio
    const before = await face(page)
    await drop(page, 'everywhere.png', await black())
    await expectValue(slider(page, 'everywhere'), 1)
    expect(await difference(before, await face(page))).toBeGreaterThan(0.05)
    await page.getByRole('button', { name: 'Remove area everywhere' }).press('Enter')
    await slider(page, 'everywhere').waitFor({ state: 'detached' })
    expect(await page.evaluate(() => document.activeElement?.className)).toBe('remove')
    expect(await difference(before, await face(page))).toBe(0)
  })

  test('an image painted the other way round is picked with the box cleared', async () => {
    const { page } = studio
    const before = await face(page)
    await page.getByLabel('White = no wrinkles').uncheck()
    const file = { name: 'nowhere.png', mimeType: 'image/png', buffer: await black() }
    await page.getByLabel('Add area').setInputFiles(file)
    await expectValue(slider(page, 'nowhere'), 1)
    expect(await difference(before, await face(page))).toBe(0)
  })

  test('a bad file is refused in words, and so is a name that is taken', async () => {
    const { page } = studio
    await drop(page, 'bad.png', Buffer.from('no image'))
    await dismiss(page, 'bad.png: not a readable image')
    expect(await slider(page, 'bad').count()).toBe(0)
    await drop(page, 'nose.png', await black())
    await dismiss(page, 'two areas of one name')
  })

  test('saves the picture as a PNG', () => savesPicture(studio.page))

  test('a page at rest draws nothing', async () => {
    const { page } = studio
    await face(page)
    const frames = await page.evaluate(async () => {
      let count = 0
      const request = window.requestAnimationFrame
      window.requestAnimationFrame = (callback) => {
        count++
        return request(callback)
      }
      await new Promise((resolve) => setTimeout(resolve, 500))
      window.requestAnimationFrame = request
      return count
    })
    expect(frames).toBe(0)
  })

  test('every control has a name and is reached by Tab, in order', () => checkControls(studio.page))

  test('fits a phone without scrolling sideways, with targets for fingers', () => fitsPhone(studio.page))
})

describe('the studio on WebGPU, switched to from WebGL', () => {
  test('keeps what was set', async () => {
    const { page } = studio
    await page.getByRole('button', { name: 'Surprised' }).click()
    await slider(page, 'glabella').fill('0.7')
    await page.getByText('WebGPU', { exact: true }).click()
    await ready(page, 'WebGPU')
    await expectValue(slider(page, 'glabella'), 0.7)
    await expectValue(slider(page, 'foreheadLeft'), 1)
  })

  test('shows the face, and every way of looking at it', () => showsLooks(studio.page, 'WebGPU'))

  test('moves the face by expressions and sliders', () => movesFace(studio.page))

  test('saves the picture as a PNG', () => savesPicture(studio.page))
})

describe('the studio back on WebGL', () => {
  test('shows what it showed before', async () => {
    const { page } = studio
    await page.getByText('WebGL', { exact: true }).click()
    await ready(page, 'WebGL 2')
    await expectValue(slider(page, 'foreheadLeft'), 1)
    expect(await spread(await face(page))).toBeGreaterThan(30)
  })

  test('says so where WebGPU is missing, and stays on WebGL', async () => {
    const { page } = studio
    await page.evaluate(() => Object.defineProperty(navigator, 'gpu', { value: undefined }))
    await page.getByText('WebGPU', { exact: true }).click()
    await dismiss(page, 'WebGPU is missing')
    expect(await page.getByRole('radio', { name: 'WebGL' }).isChecked()).toBe(true)
    expect(await spread(await face(page))).toBeGreaterThan(30)
  })
})

async function showsLooks(page: Page, backend: string): Promise<void> {
  expect(await page.textContent('#backend')).toBe(backend)
  expect(await page.textContent('#adapter')).not.toBe('')
  const shaded = await face(page)
  expect(await spread(shaded)).toBeGreaterThan(30)
  const show = page.getByRole('group', { name: 'Show' })
  for (const look of ['Normals', 'Areas', 'Wires']) {
    await show.getByText(look).click()
    expect(await difference(shaded, await face(page)), look).toBeGreaterThan(2)
  }
  await show.getByText('Areas').click()
  const all = await face(page)
  await page.getByLabel('Area', { exact: true }).selectOption('nose')
  expect(await difference(all, await face(page)), 'one area').toBeGreaterThan(0.5)
  await show.getByText('Shaded').click()
  expect(await difference(shaded, await face(page)), 'shaded again').toBe(0)
}

async function movesFace(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'Surprised' }).click()
  const surprised = await face(page)
  await page.getByRole('button', { name: 'Happy' }).click()
  await expectValue(slider(page, 'crowsFeetLeft'), 1)
  await expectValue(slider(page, 'foreheadLeft'), 0)
  const happy = await face(page)
  expect(await difference(surprised, happy)).toBeGreaterThan(0.2)

  await slider(page, 'foreheadLeft').fill('1')
  const creased = await face(page)
  expect(await difference(happy, creased)).toBeGreaterThan(0.01)
  const filter = page.getByLabel('Filter blendshapes')
  await filter.fill('jawOpen')
  await slider(page, 'jawOpen').fill('0.6')
  expect(await difference(creased, await face(page))).toBeGreaterThan(0.2)
  // Areas follow the blendshapes that drive them, and no others: 0.8 of this one, through a curve from 0.15 to 1.
  await filter.fill('browOuterUpRight')
  await slider(page, 'browOuterUpRight').fill('1')
  await expectValue(slider(page, 'foreheadRight'), (0.8 - 0.15) / 0.85)
  await expectValue(slider(page, 'foreheadLeft'), 1)

  await page.getByRole('button', { name: 'Reset all areas' }).click()
  await expectValue(slider(page, 'crowsFeetLeft'), 0)
  await page.getByRole('button', { name: 'Surprised' }).click()
  await expectValue(slider(page, 'jawOpen'), 0.25)
  await filter.fill('')
  expect(await difference(surprised, await face(page)), 'surprised again').toBe(0)
}

async function savesPicture(page: Page): Promise<void> {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Screenshot' }).click(),
  ])
  expect(download.suggestedFilename()).toMatch(/^furrow-human-.*\.png$/)
  const file = await download.path()
  const { format, width } = await sharp(file).metadata()
  expect(format).toBe('png')
  expect(width).toBe(await page.evaluate(() => document.querySelector('canvas')!.width))
  expect(await spread(await sharp(file).toBuffer())).toBeGreaterThan(30)
}

async function checkControls(page: Page): Promise<void> {
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>('button, input, select, summary, [tabindex]')]
      .filter((element) => {
        const labels = [...((element as HTMLInputElement).labels ?? [])]
        const words = [element.ariaLabel, element.textContent, ...labels.map((label) => label.textContent)]
        return !words.some((text) => text?.trim())
      })
      .map(({ outerHTML }) => outerHTML),
  )
  expect(nameless).toEqual([])
  const expected = await page.evaluate(() => {
    const controls = [...document.querySelectorAll<HTMLElement>('button, input, select, summary, [tabindex]')]
    // Of a group of radio buttons Tab reaches the one that is chosen.
    const reachable = controls.filter(
      (control) =>
        control.checkVisibility() && (!control.matches('[type=radio]') || control.matches(':checked')),
    )
    for (const [index, control] of reachable.entries()) control.dataset.reach = String(index)
    // Tab starts at the top of the page.
    document.body.tabIndex = -1
    document.body.focus()
    return reachable.length
  })
  const reached: number[] = []
  for (let i = 0; i < expected; i++) {
    await page.keyboard.press('Tab')
    reached.push(Number(await page.evaluate(() => (document.activeElement as HTMLElement).dataset.reach)))
  }
  expect(reached).toEqual([...reached.keys()])
}

async function fitsPhone(page: Page): Promise<void> {
  await page.setViewportSize(PHONE)
  const sizes = await page.evaluate(() => {
    const panel = document.querySelector('.panel')!
    const targets = [...document.querySelectorAll<HTMLElement>('button, select, summary, .row input')]
    return {
      overflow: document.documentElement.scrollWidth - innerWidth,
      pageOverflow: document.documentElement.scrollHeight - innerHeight,
      panelOverflow: panel.scrollWidth - panel.clientWidth,
      small: targets
        .filter((element) => element.checkVisibility() && element.getBoundingClientRect().height < 42)
        .map(({ outerHTML }) => outerHTML),
    }
  })
  expect(sizes).toEqual({ overflow: 0, pageOverflow: 0, panelOverflow: 0, small: [] })
  const surprised = await face(page)
  await page.getByRole('button', { name: 'Happy' }).click()
  await expectValue(slider(page, 'crowsFeetLeft'), 1)
  expect(await difference(surprised, await face(page))).toBeGreaterThan(0.2)
  await page.setViewportSize(DESKTOP)
}

/** Opens the studio, surprised and at rest; no test may make it complain. */
function openStudio(): { page: Page } {
  const studio = {} as Awaited<ReturnType<typeof openPage>>
  beforeAll(async () => {
    Object.assign(studio, await openPage(browser, { viewport: DESKTOP, reducedMotion: 'reduce' }))
    await studio.page.goto(address)
    await ready(studio.page)
    await expectValue(slider(studio.page, 'foreheadLeft'), 1)
  })
  afterEach(async () => {
    expect(studio.complaints).toEqual([])
    expect(await studio.page.textContent('#errors')).toBe('')
  })
  afterAll(() => studio.page?.close())
  return studio
}
