/** Tests painting and drawing in the studio on WebGPU, and compares the looks of the skin with WebGL. */

import type { Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { regionLabel } from '../../studio/src/labels/names.ts'
import { openStudio } from './opened-studio.ts'
import {
  areaChoice,
  button,
  chooseLook,
  chooseTool,
  meanPngDifference,
  prefer,
  shootStage,
  slider,
  startDrawingLines,
  undoIs,
  waitUntilReady,
} from './studio-page.ts'

const AREA = 'lowerLip'
const LOOKS = ['Relief', 'Strain'] as const

const studio = openStudio({ width: 1200, height: 640 })
let page: Page
/** Pictures of each look on WebGL. */
const expected = new Map<string, Buffer>()

beforeAll(async () => {
  ;({ page } = studio)
  await button(page, 'Edit wrinkles').click()
  await areaChoice(page, AREA).waitFor()
  await page.getByRole('slider', { name: /^Divider/ }).press('Home')
  for (const name of LOOKS) expected.set(name, await shootLook(name))
  await prefer(page, 'Renderer', 'WebGPU')
  await waitUntilReady(page, 'WebGPU')
})

async function shootLook(name: string): Promise<Buffer> {
  await button(page, 'Surprised').click()
  await chooseLook(page, name)
  const picture = await shootStage(page)
  await chooseLook(page, 'Shaded')
  return picture
}

/** Converts a point from fractions of an element's size to coordinates of the page. */
async function pointIn(selector: string, u: number, v: number): Promise<[x: number, y: number]> {
  const { x, y, width, height } = (await page.locator(selector).boundingBox())!
  return [x + u * width, y + v * height]
}

async function drag(selector: string, ...points: [u: number, v: number][]): Promise<void> {
  await page.mouse.move(...(await pointIn(selector, ...points[0])))
  await page.mouse.down()
  for (const point of points.slice(1))
    await page.mouse.move(...(await pointIn(selector, ...point)), { steps: 4 })
  await page.mouse.up()
}

/** Makes a change, and expects that the picture changes and that undo restores it. */
async function changesPicture(change: () => Promise<void>, label: string, least: number): Promise<void> {
  const before = await shootStage(page)
  await change()
  await undoIs(page, label)
  await expect
    .poll(async () => meanPngDifference(before, await shootStage(page)), { timeout: 60_000 })
    .toBeGreaterThan(least)
  await button(page, 'Undo').click()
  await expect
    .poll(async () => meanPngDifference(before, await shootStage(page)), { timeout: 60_000 })
    .toBe(0)
}

test.each(LOOKS)('%s looks like WebGL', async (name) => {
  const picture = await shootLook(name)
  expect(await meanPngDifference(expected.get(name)!, picture)).toBeLessThan(3)
})

test('an area is painted on the face, and shows its extent', async () => {
  await button(page, 'Neutral').click()
  await areaChoice(page, AREA).check()
  await chooseTool(page, 'Paint')
  await changesPicture(() => drag('#viewport', [0.6, 0.55], [0.63, 0.6]), `Paint ${regionLabel(AREA)}`, 0.05)
})

test('an area is painted on the view of its texture', async () => {
  await button(page, 'Texture').click()
  await changesPicture(() => drag('#texture', [0.6, 0.45], [0.65, 0.5]), `Paint ${regionLabel(AREA)}`, 0.05)
  await button(page, 'Texture').click()
})

test('a drawn line creases the skin, and its area shows it', async () => {
  await startDrawingLines(page)
  await slider(page, 'Depth, mm').fill('1')
  await changesPicture(() => drag('#viewport', [0.38, 0.58], [0.4, 0.66]), 'Draw a line', 0.01)
})
