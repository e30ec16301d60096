import type { Page } from 'playwright-core'
import sharp from 'sharp'
import { beforeAll, expect, test, vi } from 'vitest'
import { regionLabel } from '../../studio/src/labels/names.ts'
import { writePlain } from './avatars.ts'
import { openStudio } from './opened-studio.ts'
import {
  areaChoice,
  button,
  chooseTool,
  dismiss,
  dropPlain,
  eventually,
  expectPicture,
  expectValue,
  meanPngDifference,
  shootAside,
  slider,
  undoIs,
} from './studio-page.ts'

/** An automatic area of the forehead. */
const AREA = 'foreheadInnerLeft'

const studio = openStudio({ width: 1200, height: 640 }, writePlain)
const { folder } = studio
let page: Page
/** URLs of the workers that the page has started. */
const workers: string[] = []
/** Position of the cheek on the page. */
let cheek: { x: number; y: number }
/** Upper left corner of the stage on the page. */
let corner: { x: number; y: number }

beforeAll(async () => {
  ;({ page } = studio)
  page.on('worker', (worker) => workers.push(worker.url()))
  await dropPlain(page, folder, AREA)
  const { x, y, width, height } = (await page.locator('#viewport').boundingBox())!
  corner = { x, y }
  cheek = { x: x + 0.62 * width, y: y + 0.58 * height }
})

test('a worker prepares the skin before painting', async () => {
  const paintWorkers = () => workers.filter((url) => url.includes('/paint/worker'))
  await eventually(() => expect(paintWorkers().length).toBe(1))
})

test('a stroke on the cheek paints the selected area there, and undo removes it completely', async () => {
  await areaChoice(page, AREA).check()
  await chooseTool(page, 'Paint')
  const before = await shootAside(page)
  await stroke()
  await page.mouse.up()
  await undoIs(page, `Paint ${regionLabel(AREA)}`)
  const painted = await shootAside(page)
  expect(await differenceAt(before, painted, cheek)).toBeGreaterThan(15)
  expect(await differenceAt(before, painted, { x: cheek.x, y: cheek.y - 150 })).toBe(0)
  await button(page, 'Undo').click()
  await expectPicture(page, before)
  await button(page, 'Redo').click()
  await expectPicture(page, painted)
  await button(page, 'Undo').click()
  await expectPicture(page, before)
})

test('Escape cancels a stroke in progress', async () => {
  const before = await shootAside(page)
  await stroke()
  await page.keyboard.press('Escape')
  await page.mouse.up()
  expect(await meanPngDifference(before, await shootAside(page))).toBe(0)
  expect(await button(page, 'Undo').isDisabled()).toBe(true)
})

test('keys change the brush, and Alt leaves the pointer to the camera', async () => {
  const before = await shootAside(page)
  const size = slider(page, 'Size')
  const old = Number(await size.inputValue())
  await page.keyboard.press(']')
  await vi.waitFor(async () => expect(Number(await size.inputValue())).toBeGreaterThan(old))
  await page.keyboard.press('[')
  await page.keyboard.press('x')
  await vi.waitFor(async () =>
    expect(await page.getByLabel('Remove', { exact: true }).isChecked()).toBe(true),
  )
  await page.keyboard.press('x')
  await page.keyboard.down('Alt')
  await stroke()
  await page.mouse.up()
  await page.keyboard.up('Alt')
  await expectCameraMoved(before)
})

test('two fingers move the camera, even after the first one began a stroke', async () => {
  const before = await shootAside(page)
  const session = await page.context().newCDPSession(page)
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...offsets: number[]) =>
    session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: offsets.map((offset, id) => ({ x: cheek.x + offset, y: cheek.y, id })),
    })
  await touch('touchStart', 0)
  await touch('touchMove', -5)
  await touch('touchStart', -5, 40)
  await touch('touchMove', -30, 70)
  await touch('touchMove', -60, 90)
  await touch('touchEnd')
  await session.detach()
  await expectCameraMoved(before)
})

test('an area can be renamed, and undo restores its name', async () => {
  await chooseTool(page, 'Select')
  await page.getByText('Advanced', { exact: true }).click()
  await page.getByLabel('Name in the file', { exact: true }).fill('brow')
  await page.keyboard.press('Enter')
  await areaChoice(page, 'brow').waitFor()
  await areaChoice(page, AREA).waitFor({ state: 'detached' })
  await page.getByLabel('Name in the file', { exact: true }).fill('chin')
  await page.keyboard.press('Enter')
  await dismiss(page, 'another area already has this name')
  expect(await page.getByLabel('Name in the file', { exact: true }).inputValue()).toBe('brow')
  await button(page, 'Undo').click()
  await areaChoice(page, AREA).waitFor()
})

test('an area can be deleted, and undo restores it', async () => {
  await areaChoice(page, AREA).check()
  await button(page, 'Delete').click()
  await areaChoice(page, AREA).waitFor({ state: 'detached' })
  await button(page, 'Undo').click()
  await areaChoice(page, AREA).waitFor()
})

test('a muted area is hidden in the picture, and stays in the document', async () => {
  await page.getByRole('slider', { name: /^Divider/ }).press('Home')
  const before = await shootAside(page)
  await slider(page, AREA).fill('1')
  await button(page, `Hide ${AREA}`).click()
  await expectPicture(page, before)
  await expectValue(slider(page, AREA), 1)
  await button(page, `Hide ${AREA}`).click()
  await button(page, 'Solo chin').click()
  await expectPicture(page, before)
  await button(page, 'Solo chin').click()
  expect(await meanPngDifference(before, await shootAside(page))).toBeGreaterThan(0.05)
})

test('painted skin without lines can be filled with lines', async () => {
  await button(page, 'New region').click()
  await chooseTool(page, 'Paint')
  await stroke()
  await page.mouse.up()
  const card = page.getByRole('region', { name: 'Fill with lines' })
  await card.getByRole('button', { name: 'Fill with lines' }).click()
  await undoIs(page, 'Fill Area with lines')
  expect(await card.count()).toBe(0)
})

/** Drags the mouse over the cheek in small steps, like a hand. */
async function stroke(): Promise<void> {
  await page.mouse.move(cheek.x, cheek.y)
  await page.mouse.down()
  await page.mouse.move(cheek.x + 20, cheek.y + 12, { steps: 4 })
}

/** Expects that the camera has moved and nothing else has changed. Resets the camera and selects the brush again. */
async function expectCameraMoved(before: Buffer): Promise<void> {
  expect(await button(page, 'Undo').isDisabled()).toBe(true)
  expect(await meanPngDifference(before, await shootAside(page))).toBeGreaterThan(1)
  await button(page, 'Front').click()
  await expectPicture(page, before)
}

/** Returns the mean difference of two pictures of the stage, 0..255, in a square of 20 pixels at a point of the page. */
async function differenceAt(a: Buffer, b: Buffer, { x, y }: { x: number; y: number }): Promise<number> {
  const [left, top] = [x - corner.x, y - corner.y].map((at) => Math.round(at - 5))
  const rectangle = { left, top, width: 20, height: 20 }
  const [one, other] = await Promise.all([a, b].map((png) => sharp(png).extract(rectangle).png().toBuffer()))
  return meanPngDifference(one, other)
}
