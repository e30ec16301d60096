import type { Page } from 'playwright-core'
import sharp from 'sharp'
import type { ViteDevServer } from 'vite'
import { afterAll, afterEach, beforeAll, describe, expect, test } from 'vitest'
import { openPage, useBrowser } from './browser.ts'
import { serveStudio } from './opened-studio.ts'
import { movesFace, savesPicture, showsLooks } from './studio-face.ts'
import {
  addImages,
  blackPng,
  brightnessDeviation,
  button,
  dismiss,
  drop,
  expectValue,
  meanPngDifference,
  prefer,
  shootStage,
  showSliders,
  showTab,
  slider,
  transitionValues,
  waitUntilReady,
} from './studio-page.ts'

const DESKTOP = { width: 1000, height: 560 }
const PHONE = { width: 390, height: 844 }

let server: ViteDevServer
let address: string
const browser = useBrowser()

beforeAll(async () => {
  ;({ server, address } = await serveStudio())
})

afterAll(async () => {
  await server?.close()
})

const studio = openStudio()

describe('the studio on WebGL', () => {
  test('shows a different picture for every look', () => showsLooks(studio.page, 'WebGL 2'))

  test('moves the face by expressions and sliders', () => movesFace(studio.page))

  test('moves to an expression gradually, but at once with reduced motion', async () => {
    const { page } = studio
    await page.emulateMedia({ reducedMotion: 'no-preference' })
    expect((await transitionValues(page, 'Angry', 'glabella')).length).toBeGreaterThan(2)
    await page.emulateMedia({ reducedMotion: 'reduce' })
    expect(await transitionValues(page, 'Surprised', 'glabella')).toEqual([0])
    await expectValue(slider(page, 'foreheadLeft'), 1)
  })

  test('shows the drivers of a hovered area, and the areas of a hovered blendshape', async () => {
    const { page } = studio
    await page.getByRole('button', { name: 'Happy' }).click()
    await expectValue(slider(page, 'mouthSmileLeft'), 0.8)
    const before = await shootStage(page)
    await page.locator('#areas label', { hasText: 'crowsFeetLeft' }).hover()
    const meter = (name: string) => page.getByRole('meter', { name })
    expect(await meter('Crow’s feet, left').getAttribute('value')).toBe('1')
    expect(await meter('Cheek raised, left').getAttribute('value')).toBe('0.64')
    const linked = () =>
      page.locator('.row.linked label').evaluateAll((all) => all.map((label) => (label as HTMLElement).title))
    expect((await linked()).sort()).toEqual([
      'cheekSquintLeft',
      'eyeBlinkLeft',
      'eyeSquintLeft',
      'mouthSmileLeft',
    ])
    // The face shows the hovered area.
    expect(await meanPngDifference(before, await shootStage(page))).toBeGreaterThan(2)
    await page.locator('#filter').fill('mouthSmileLeft')
    await page.locator('#targets label', { hasText: 'mouthSmileLeft' }).hover()
    expect((await linked()).sort()).toEqual(['crowsFeetLeft', 'nasolabialLeft', 'underEyeLeft'])
    expect(await meter('Cheek raised, left').count()).toBe(0)
    await page.locator('#filter').fill('')
    await page.locator('#filter').hover()
    expect(await linked()).toEqual([])
    expect(await meanPngDifference(before, await shootStage(page))).toBeLessThan(0.5)
    await page.getByRole('button', { name: 'Surprised' }).click()
    await expectValue(slider(page, 'foreheadLeft'), 1)
  })

  test('moves the divider by keyboard and pointer', async () => {
    const { page } = studio
    const divider = page.getByRole('slider', { name: /^Divider/ })
    const middle = await shootStage(page)
    await divider.press('End')
    expect(await divider.getAttribute('aria-valuenow')).toBe('100')
    const without = await shootStage(page)
    await divider.press('Home')
    const wrinkled = await shootStage(page)
    expect(await meanPngDifference(without, wrinkled)).toBeGreaterThan(0.05)
    expect(await meanPngDifference(middle, without)).toBeGreaterThan(0.01)
    expect(await meanPngDifference(middle, wrinkled)).toBeGreaterThan(0.01)
    await divider.press('ArrowRight')
    expect(await divider.getAttribute('aria-valuenow')).toBe('2')
    const { x, y, width, height } = (await divider.boundingBox())!
    await page.mouse.move(x + width / 2, y + height / 2)
    await page.mouse.down()
    await page.mouse.move(x + width / 2 + 200, y + height / 2)
    await page.mouse.up()
    expect(Number(await divider.getAttribute('aria-valuenow'))).toBeGreaterThan(20)
  })

  test('turns a dropped image into an area that can be removed', async () => {
    const { page } = studio
    const before = await shootStage(page)
    await drop(page, 'everywhere.png', await blackPng())
    await addImages(page)
    await expectValue(slider(page, 'everywhere'), 1)
    expect(await meanPngDifference(before, await shootStage(page))).toBeGreaterThan(0.03)
    await page.getByRole('button', { name: 'Remove region everywhere' }).press('Enter')
    await slider(page, 'everywhere').waitFor({ state: 'detached' })
    expect(await page.evaluate(() => document.activeElement?.className)).toBe('remove')
    expect(await meanPngDifference(before, await shootStage(page))).toBe(0)
  })

  test('reads white as visible if the checkbox is cleared', async () => {
    const { page } = studio
    const before = await shootStage(page)
    await page.getByLabel('White = no wrinkles').uncheck()
    const file = { name: 'nowhere.png', mimeType: 'image/png', buffer: await blackPng() }
    await page.getByLabel('Add from image').setInputFiles(file)
    await expectValue(slider(page, 'nowhere'), 1)
    expect(await meanPngDifference(before, await shootStage(page))).toBe(0)
  })

  test('refuses an invalid file and a duplicate name with a message', async () => {
    const { page } = studio
    await drop(page, 'bad.png', Buffer.from('no image'))
    await dismiss(page, 'bad.png: not a readable image')
    expect(await slider(page, 'bad').count()).toBe(0)
    await drop(page, 'nose.png', await blackPng())
    await addImages(page)
    await dismiss(page, 'two areas with the same name')
  })

  test('saves the picture as a PNG', () => savesPicture(studio.page))

  test('saves the UV layout as a PNG to paint over', () => savesUvLayout(studio.page))

  test('draws nothing while idle', async () => {
    const { page } = studio
    await shootStage(page)
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

  test('names every control, and reaches all of them by Tab in order', () => checkControls(studio.page))

  test('fits a phone without horizontal scrolling, with large touch targets', () => fitsPhone(studio.page))
})

describe('the studio without WebGPU', () => {
  test('stays on WebGL with a message if WebGPU is missing', async () => {
    const { page } = studio
    await page.evaluate(() => Object.defineProperty(navigator, 'gpu', { value: undefined }))
    await prefer(page, 'Renderer', 'WebGPU')
    await dismiss(page, 'WebGPU is missing')
    expect(await page.textContent('#backend')).toBe('WebGL 2')
    expect(await brightnessDeviation(await shootStage(page))).toBeGreaterThan(30)
  })
})

/** Checks the saved UV layout: islands with lines over the base colour, and transparency around them. */
async function savesUvLayout(page: Page): Promise<void> {
  await button(page, 'Edit wrinkles').click()
  await showTab(page, 'Maps')
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save UV layout' }).click(),
  ])
  expect(download.suggestedFilename()).toBe('human-uv.png')
  await page.getByText('Saved the UV layout').waitFor()
  const image = sharp(await download.path())
  const { format, width, height, channels } = await image.metadata()
  expect({ format, width, height, channels }).toEqual({
    format: 'png',
    width: 2048,
    height: 2048,
    channels: 4,
  })
  const [red, , , alpha] = (await image.stats()).channels
  expect([alpha.min, alpha.max]).toEqual([0, 255])
  // The islands cover between 30% and 95% of the texture.
  expect(alpha.mean / 255).toBeGreaterThan(0.3)
  expect(alpha.mean / 255).toBeLessThan(0.95)
  expect(red.stdev).toBeGreaterThan(10)
}

async function checkControls(page: Page): Promise<void> {
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>('button, input, select, summary, [tabindex]')]
      .filter((element) => {
        const labels = [...((element as HTMLInputElement).labels ?? [])]
        const labelling = document.getElementById(element.getAttribute('aria-labelledby') ?? '')
        const named = [element, labelling, ...labels]
        const words = [element.ariaLabel, ...named.map((each) => each?.textContent)]
        return !words.some((text) => text?.trim())
      })
      .map(({ outerHTML }) => outerHTML),
  )
  expect(nameless).toEqual([])
  const expected = await page.evaluate(() => {
    const controls = [...document.querySelectorAll<HTMLElement>('button, input, select, summary, [tabindex]')]
    // Tab stops only at the selected radio button of a group, or at the first one if none is selected.
    const isStop = (control: HTMLElement) => {
      const name = control.getAttribute('name')
      const group = [...document.querySelectorAll<HTMLInputElement>(`[type=radio][name="${name}"]`)]
      return control === (group.find(({ checked }) => checked) ?? group[0])
    }
    const reachable = controls.filter(
      (control) =>
        control.checkVisibility() &&
        !control.matches(':disabled') &&
        !control.matches('[tabindex="-1"]') &&
        (!control.matches('[type=radio]') || isStop(control)),
    )
    for (const [index, control] of reachable.entries()) control.dataset.reach = String(index)
    // Makes the body focusable, so that Tab starts at the top of the page.
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
  for (const sheet of ['Regions', 'Selection', 'Expressions']) {
    const tab = page.getByRole('navigation', { name: 'Panels' }).getByRole('button', { name: sheet })
    if ((await tab.getAttribute('aria-expanded')) === 'false') await tab.click()
    const sizes = await page.evaluate(() => {
      const targets = [...document.querySelectorAll<HTMLElement>('button, select, summary, .row input')]
      return {
        overflow: document.documentElement.scrollWidth - innerWidth,
        pageOverflow: document.documentElement.scrollHeight - innerHeight,
        small: targets
          .filter((element) => element.checkVisibility() && element.getBoundingClientRect().height < 42)
          .map(({ outerHTML }) => outerHTML),
      }
    })
    expect(sizes, sheet).toEqual({ overflow: 0, pageOverflow: 0, small: [] })
  }
  const surprised = await shootStage(page)
  await button(page, 'Happy').click()
  await expectValue(slider(page, 'crowsFeetLeft'), 1)
  expect(await meanPngDifference(surprised, await shootStage(page))).toBeGreaterThan(0.2)
  await page.setViewportSize(DESKTOP)
}

/** Opens the studio for the current `describe`. Fails at the end if the page has reported errors. */
function openStudio(): { page: Page } {
  const studio = {} as Awaited<ReturnType<typeof openPage>>
  beforeAll(async () => {
    Object.assign(studio, await openPage(browser(), { viewport: DESKTOP, reducedMotion: 'reduce' }))
    await studio.page.goto(address)
    await waitUntilReady(studio.page)
    await showSliders(studio.page)
    await expectValue(slider(studio.page, 'foreheadLeft'), 1)
  })
  afterEach(async () => {
    expect(studio.complaints).toEqual([])
    expect(await studio.page.textContent('#errors')).toBe('')
  })
  afterAll(() => studio.page?.close())
  return studio
}
