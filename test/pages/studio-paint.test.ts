import { join } from 'node:path'
import type { Page } from 'playwright-core'
import sharp from 'sharp'
import { beforeAll, expect, test, vi } from 'vitest'
import { openStudio } from './opened-studio.ts'
import { dismiss, dropPaths, expectValue, meanPngDifference, shootStage, slider } from './studio-page.ts'

/** An automatic area of the forehead. */
const AREA = 'foreheadInnerLeft'

const studio = openStudio({ width: 900, height: 600 })
const { folder } = studio
let page: Page
/** The cheek on the page. */
let cheek: { x: number; y: number }

beforeAll(async () => {
  ;({ page } = studio)
  await dropPaths(page, [join(folder, 'plain.glb')], 'Plain')
  await choice(AREA).waitFor()
  const { x, y, width, height } = (await page.locator('#viewport').boundingBox())!
  cheek = { x: x + 0.62 * width, y: y + 0.58 * height }
})

const choice = (area: string) => page.getByRole('radio', { name: `Edit area ${area}`, exact: true })
const button = (name: string) => page.getByRole('button', { name, exact: true })

test('a stroke on the cheek paints the chosen area there; undo takes it back without a trace', async () => {
  await choice(AREA).check()
  await button('Paint').click()
  const before = await shootAside()
  await stroke()
  await page.mouse.up()
  await undoIs(`Paint ${AREA}`)
  const painted = await shootAside()
  expect(await differenceAt(before, painted, cheek)).toBeGreaterThan(50)
  expect(await differenceAt(before, painted, { x: cheek.x, y: cheek.y - 150 })).toBe(0)
  await button('Undo').click()
  await expectPicture(before)
  await button('Redo').click()
  await expectPicture(painted)
  await button('Undo').click()
  await expectPicture(before)
})

test('Escape takes back a stroke that is under way', async () => {
  const before = await shootAside()
  await stroke()
  await page.keyboard.press('Escape')
  await page.mouse.up()
  expect(await meanPngDifference(before, await shootAside())).toBe(0)
  expect(await button('Undo').isDisabled()).toBe(true)
})

test('keys change the brush, and Alt leaves the pointer to the camera', async () => {
  const before = await shootAside()
  const size = page.getByLabel('Size').last()
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
  expect(await button('Undo').isDisabled()).toBe(true)
  expect(await meanPngDifference(before, await shootAside())).toBeGreaterThan(1)
  await button('Front').click()
  await expectPicture(before)
  await button('Paint').click()
})

test('two fingers move the camera, though the first one had begun a stroke', async () => {
  await button('Paint').click()
  const before = await shootAside()
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
  expect(await button('Undo').isDisabled()).toBe(true)
  expect(await meanPngDifference(before, await shootAside())).toBeGreaterThan(1)
  await button('Front').click()
  await expectPicture(before)
  await button('Paint').click()
})

test('an area gets another name, and its own back by undo', async () => {
  await page.getByLabel('Name', { exact: true }).fill('brow')
  await page.keyboard.press('Enter')
  await choice('brow').waitFor()
  await choice(AREA).waitFor({ state: 'detached' })
  await page.getByLabel('Name', { exact: true }).fill('chin')
  await page.keyboard.press('Enter')
  await dismiss(page, 'two of the areas would have one name')
  expect(await page.getByLabel('Name', { exact: true }).inputValue()).toBe('brow')
  await button('Undo').click()
  await choice(AREA).waitFor()
})

test('an area is deleted, and comes back by undo', async () => {
  await choice(AREA).check()
  await button('Delete').click()
  await choice(AREA).waitFor({ state: 'detached' })
  await button('Undo').click()
  await choice(AREA).waitFor()
  await button(`Remove area ${AREA}`).click()
  await choice(AREA).waitFor({ state: 'detached' })
  await vi.waitFor(async () =>
    expect(await page.evaluate(() => document.activeElement?.className)).toBe('remove'),
  )
  await button('Undo').click()
  await choice(AREA).waitFor()
})

test('a muted area is left out of the picture only', async () => {
  await page.getByRole('slider', { name: /^Divider/ }).press('Home')
  const before = await shootAside()
  await slider(page, AREA).fill('1')
  await button(`Mute ${AREA}`).click()
  await expectPicture(before)
  await expectValue(slider(page, AREA), 1)
  await button(`Mute ${AREA}`).click()
  await button('Solo chin').click()
  await expectPicture(before)
  await button('Solo chin').click()
  expect(await meanPngDifference(before, await shootAside())).toBeGreaterThan(0.05)
})

/** Presses the mouse on the cheek and drags it, as often as a hand that is seen in every frame. */
async function stroke(): Promise<void> {
  await page.mouse.move(cheek.x, cheek.y)
  await page.mouse.down()
  await page.mouse.move(cheek.x + 20, cheek.y + 12, { steps: 4 })
}

async function undoIs(label: string): Promise<void> {
  await vi.waitFor(async () => expect(await button('Undo').getAttribute('title')).toBe(`Undo: ${label}`))
}

/** Without the outlines of the brush and of the focus, nor what is hovered. */
async function shootAside(): Promise<Buffer> {
  await page.mouse.move(880, 10)
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur())
  return shootStage(page)
}

/** Waits until the stage is as a picture shows it, to the last bit. */
async function expectPicture(picture: Buffer): Promise<void> {
  const check = async () => expect(await meanPngDifference(picture, await shootAside())).toBe(0)
  await vi.waitFor(check, { timeout: 60_000, interval: 200 })
}

/** Mean difference of two pictures of the stage within 10 pixels of a point of the page, in 0..255. */
async function differenceAt(a: Buffer, b: Buffer, { x, y }: { x: number; y: number }): Promise<number> {
  const rectangle = { left: Math.round(x - 5), top: Math.round(y - 65), width: 20, height: 20 }
  const [one, other] = await Promise.all([a, b].map((png) => sharp(png).extract(rectangle).png().toBuffer()))
  return meanPngDifference(one, other)
}
