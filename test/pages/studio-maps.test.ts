/** Tests the view of the texture, tools that paint areas, views of the stage, and previews of the control under the pointer. */

import type { Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { regionLabel } from '../../studio/src/labels/names.ts'
import { openStudio } from './opened-studio.ts'
import {
  areaChoice,
  blackPng,
  button,
  chooseLook,
  chooseTool,
  dropPlain,
  eventually,
  expectPicture,
  meanPngDifference,
  shootAside,
  shootStage,
  showSliders,
  slider,
  undoIs,
} from './studio-page.ts'

/** An automatic area of the forehead. */
const AREA = 'foreheadInnerLeft'

const studio = openStudio({ width: 1100, height: 640 })
const { folder } = studio
let page: Page

beforeAll(async () => {
  ;({ page } = studio)
  await dropPlain(page, folder, AREA)
  await page.getByText('Making wrinkles').waitFor({ state: 'detached' })
})

const texture = () => page.getByRole('application', { name: /^Texture/ })

test('the texture is shown next to the face, moves by keys and wheel, and resets', async () => {
  const { width } = (await page.locator('#stage').boundingBox())!
  await areaChoice(page, AREA).check()
  await button(page, 'Texture').click()
  const [stage, view] = await Promise.all([page.locator('#stage').boundingBox(), texture().boundingBox()])
  expect(stage!.width).toBeCloseTo(width / 2, 0)
  expect(view!.x).toBeCloseTo(stage!.x + stage!.width, 0)
  const whole = await shootTexture()
  const moved = async () => expect(await meanPngDifference(whole, await shootTexture())).toBeGreaterThan(3)
  for (const key of ['+', 'ArrowRight']) {
    await texture().press(key)
    await eventually(moved)
  }
  await texture().press('0')
  // After the first zoom, Chromium scales the picture with another filter. This changes fine lines by up to 1.7.
  await eventually(async () => expect(await meanPngDifference(whole, await shootTexture())).toBeLessThan(2))
  await texture().hover({ position: { x: 60, y: 200 } })
  await page.mouse.wheel(0, -300)
  await eventually(moved)
  await texture().press('0')
})

test('a stroke on the texture paints the same place on the face and in the thumbnail', async () => {
  await chooseTool(page, 'Paint')
  const thumbnail = () =>
    areaChoice(page, AREA).evaluate((radio) => (radio.nextElementSibling as HTMLCanvasElement).toDataURL())
  const [before, small] = [await shootAside(page), await thumbnail()]
  const { x, y, width, height } = (await texture().boundingBox())!
  await page.mouse.move(x + 0.46 * width, y + 0.55 * height)
  await page.mouse.down()
  await page.mouse.move(x + 0.54 * width, y + 0.55 * height, { steps: 5 })
  await page.mouse.up()
  await undoIs(page, `Paint ${regionLabel(AREA)}`)
  const painted = await shootAside(page)
  expect(await meanPngDifference(before, painted)).toBeGreaterThan(0.1)
  await eventually(async () => expect(await thumbnail()).not.toBe(small))
  await button(page, 'Undo').click()
  await expectPicture(page, before)
  expect(await thumbnail()).toBe(small)
})

test('a polygon on the texture paints its inside on the face, and is outlined while drawn', async () => {
  await chooseTool(page, 'Polygon')
  const [face, map] = [await shootAside(page), await shootTexture()]
  const { x, y, width, height } = (await texture().boundingBox())!
  const corners = [
    [0.45, 0.54],
    [0.55, 0.54],
    [0.5, 0.59],
  ]
  for (const [u, v] of corners) await page.mouse.click(x + u * width, y + v * height)
  await eventually(async () => {
    const circles = await texture().locator('circle').all()
    const boxes = await Promise.all(circles.map((circle) => circle.boundingBox()))
    const seen = boxes.map((box) => [box!.x + box!.width / 2 - x, box!.y + box!.height / 2 - y])
    expect(seen.length).toBe(corners.length)
    for (const [i, [u, v]] of corners.entries()) {
      expect(Math.hypot(seen[i][0] - u * width, seen[i][1] - v * height)).toBeLessThan(1)
    }
  })
  // Clicking the first point again closes the polygon.
  await page.mouse.click(x + corners[0][0] * width, y + corners[0][1] * height)
  await undoIs(page, `Paint ${regionLabel(AREA)}`)
  expect(await meanPngDifference(face, await shootAside(page))).toBeGreaterThan(0.1)
  await button(page, 'Undo').click()
  await expectPicture(page, face)
  await eventually(async () => expect(await meanPngDifference(map, await shootTexture())).toBe(0))
  await chooseTool(page, 'Select')
})

test('a drag beside the skin moves the texture and paints nothing', async () => {
  await chooseTool(page, 'Paint')
  const before = await shootTexture()
  const { x, y, width, height } = (await texture().boundingBox())!
  await page.mouse.move(x + 0.5 * width, y + 0.03 * height)
  await page.mouse.down()
  await page.mouse.move(x + 0.3 * width, y + 0.2 * height, { steps: 3 })
  await page.mouse.up()
  await eventually(async () =>
    expect(await meanPngDifference(before, await shootTexture())).toBeGreaterThan(3),
  )
  expect(await button(page, 'Undo').isDisabled()).toBe(true)
  await chooseTool(page, 'Select')
  await button(page, 'Texture').click()
  expect(await texture().isVisible()).toBe(false)
})

test('an area is painted by a polygon, filled from an image, and mirrored', async () => {
  await areaChoice(page, 'crowsFeetLeft').check()
  await chooseTool(page, 'Polygon')
  const before = await shootAside(page)
  const { x, y, width, height } = (await page.locator('#viewport').boundingBox())!
  const corners = [
    [0.42, 0.5],
    [0.58, 0.5],
    [0.5, 0.62],
  ]
  const draw = async () => {
    for (const [u, v] of corners) await page.mouse.click(x + u * width, y + v * height)
  }
  await draw()
  await page.keyboard.press('Escape')
  expect(await button(page, 'Close polygon').isDisabled()).toBe(true)
  await draw()
  await page.keyboard.press('Enter')
  await undoIs(page, 'Paint Crow’s feet, left')
  const painted = await shootAside(page)
  expect(await meanPngDifference(before, painted)).toBeGreaterThan(0.5)
  await draw()
  const [[u, v]] = corners
  await page.mouse.click(x + u * width + 2, y + v * height - 2)
  expect(await button(page, 'Clear').isDisabled()).toBe(true)
  await button(page, 'Copy to the other side').click()
  await undoIs(page, 'Mirror Crow’s feet, left')
  expect(await areaChoice(page, 'crowsFeetRight').isChecked()).toBe(true)
  const input = page.getByLabel('Fill Crow’s feet, right from an image')
  await input.setInputFiles({ name: 'all.png', mimeType: 'image/png', buffer: await blackPng() })
  await undoIs(page, 'Fill Crow’s feet, right from an image')
  while (await button(page, 'Undo').isEnabled()) await button(page, 'Undo').click()
  await areaChoice(page, 'crowsFeetLeft').check()
  await expectPicture(page, before)
  await chooseTool(page, 'Select')
})

test('the face is shown as clay, and by its strain, which follows the pose', async () => {
  const shaded = await shootAside(page)
  await chooseLook(page, 'Relief')
  expect(await meanPngDifference(shaded, await shootAside(page))).toBeGreaterThan(2)
  await chooseLook(page, 'Strain')
  const rest = await shootAside(page)
  expect(await meanPngDifference(shaded, rest)).toBeGreaterThan(2)
  await button(page, 'Surprised').click()
  expect(await meanPngDifference(rest, await shootAside(page))).toBeGreaterThan(2)
  await button(page, 'Neutral').click()
  await expectPicture(page, rest)
  await chooseLook(page, 'Shaded')
  await expectPicture(page, shaded)
})

test('the onset maps of automatic wrinkles are shown, one layer at a time', async () => {
  const shaded = await shootAside(page)
  await chooseLook(page, 'Onset')
  const layer = page.getByLabel('Onset of', { exact: true })
  const names = await layer.locator('option').allInnerTexts()
  expect(names.slice(0, 2)).toEqual(['auto1', 'auto2'])
  const first = await shootAside(page)
  expect(await meanPngDifference(shaded, first)).toBeGreaterThan(2)
  await layer.selectOption('auto2')
  expect(await page.textContent('#side-with')).toBe('Onset of auto2')
  expect(await meanPngDifference(first, await shootAside(page))).toBeGreaterThan(0.1)
  await chooseLook(page, 'Shaded')
  await expectPicture(page, shaded)
})

test('the light turns by keys and by dragging its ball; nothing turns on its own with reduced motion', async () => {
  const before = await shootAside(page)
  const ball = page.getByRole('slider', { name: 'Light', exact: true })
  const turned = async () =>
    expect(await meanPngDifference(before, await shootAside(page))).toBeGreaterThan(0.5)
  for (let i = 0; i < 6; i++) await ball.press('ArrowRight')
  expect(await ball.getAttribute('aria-valuetext')).toBe('16° from the left, 44° from above')
  await turned()
  await ball.press('Home')
  await expectPicture(page, before)
  const { x, y, width, height } = (await ball.boundingBox())!
  await page.mouse.move(x + 0.5 * width, y + 0.5 * height)
  await page.mouse.down()
  await page.mouse.move(x + 0.9 * width, y + 0.5 * height, { steps: 3 })
  await page.mouse.up()
  await turned()
  await ball.press('Home')
  await expectPicture(page, before)
  expect(await button(page, 'Turntable').isDisabled()).toBe(true)
})

test('the face moves, lit from the side, for an area that is hovered or focused, and then returns to its pose', async () => {
  await showSliders(page)
  // A search unfolds the groups that contain results.
  await page.locator('#filter').fill('o')
  await slider(page, 'jawOpen').fill('0.3')
  await slider(page, 'noseLeft').fill('0.4')
  const before = await shootAside(page)
  const values = async (...names: string[]) =>
    Promise.all(names.map(async (name) => Number(await slider(page, name).inputValue())))
  await page.locator('#areas label', { hasText: 'crowsFeetLeft' }).hover()
  await eventually(async () => expect((await values('crowsFeetLeft'))[0]).toBeGreaterThan(0.5))
  // 0.12 is the weight in the expression `happy`.
  expect(await values('jawOpen')).toEqual([0.12])
  expect(await meanPngDifference(before, await shootStage(page))).toBeGreaterThan(2)
  await expectPicture(page, before)
  expect(await values('jawOpen', 'noseLeft', 'crowsFeetLeft')).toEqual([0.3, 0.4, 0])
  // Tab stops only at the selected radio button of a list.
  await areaChoice(page, 'noseLeft').check()
  await shootAside(page)
  await areaChoice(page, 'noseLeft').focus()
  await page.keyboard.press('Shift+Tab')
  await page.keyboard.press('Tab')
  await eventually(async () => expect((await values('jawOpen'))[0]).toBe(0))
  // Moving a slider first restores the pose before the preview.
  await slider(page, 'mouthPucker').fill('0.5')
  expect(await values('jawOpen', 'noseLeft', 'mouthPucker')).toEqual([0.3, 0.4, 0.5])
  expect(await button(page, 'Undo').isDisabled()).toBe(true)
})

async function shootTexture(): Promise<Buffer> {
  await page.mouse.move(10, 600)
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur())
  await page.evaluate(
    () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
  )
  return page.screenshot({ clip: (await texture().boundingBox())! })
}
