/** Tests that brushes sculpt skin: on the face at once, in the saved project, and exactly back with undo. */

import { readFileSync } from 'node:fs'
import { unzipSync } from 'fflate'
import { decodeSculpted } from 'furrow-files'
import type { Page } from 'playwright-core'
import sharp from 'sharp'
import { beforeAll, expect, test } from 'vitest'
import { writePlain } from './avatars.ts'
import { openStudio } from './opened-studio.ts'
import {
  button,
  chooseTool,
  dropPlain,
  eventually,
  expectPicture,
  meanPngDifference,
  saveProject,
  shootAside,
  slider,
  undoIs,
} from './studio-page.ts'

const studio = openStudio({ width: 1200, height: 640 }, writePlain)
let page: Page
/** Position on the page of the skin below the eye, beside the nose. */
let cheek: { x: number; y: number }
/** Upper left corner of the stage on the page. */
let corner: { x: number; y: number }
/** Picture before anything is sculpted. */
let before: Buffer

beforeAll(async () => {
  ;({ page } = studio)
  await dropPlain(page, studio.folder, 'foreheadInnerLeft')
  await page.getByText('Making wrinkles').waitFor({ state: 'detached' })
  const { x, y, width, height } = (await page.locator('#viewport').boundingBox())!
  corner = { x, y }
  cheek = { x: x + 0.62 * width, y: y + 0.58 * height }
  await page.getByRole('slider', { name: /^Divider/ }).press('Home')
  before = await shootAside(page)
})

/** Drags the mouse over the cheek in small steps, like a hand. */
async function stroke(): Promise<void> {
  await page.mouse.move(cheek.x, cheek.y)
  await page.mouse.down()
  await page.mouse.move(cheek.x + 20, cheek.y + 12, { steps: 4 })
}

/** Returns the mean difference of two pictures of the stage, 0..255, in a square of 30 pixels at the cheek. */
async function differenceAtCheek(a: Buffer, b: Buffer): Promise<number> {
  const [left, top] = [cheek.x - corner.x, cheek.y - corner.y].map((at) => Math.round(at - 10))
  const rectangle = { left, top, width: 30, height: 30 }
  const [one, other] = await Promise.all([a, b].map((png) => sharp(png).extract(rectangle).png().toBuffer()))
  return meanPngDifference(one, other)
}

/** Returns the sculpted heights in the saved project, by path. */
async function savedHeights(): Promise<Map<string, Float32Array>> {
  const files = Object.entries(unzipSync(readFileSync(await (await saveProject(page)).path())))
  const images = files.filter(([path]) => /layers\/.*\/sculpted\.png$/.test(path))
  return new Map(
    await Promise.all(
      images.map(async ([path, bytes]): Promise<[string, Float32Array]> => {
        return [path, (await decodeSculpted(bytes, path, 'test')).data]
      }),
    ),
  )
}

test('a stroke raises the skin under the brush at once, and is in the saved project', async () => {
  await chooseTool(page, 'Sculpt')
  await slider(page, 'Height, mm').fill('2')
  await stroke()
  await page.mouse.up()
  await undoIs(page, 'Sculpt')
  await eventually(async () =>
    expect(await differenceAtCheek(before, await shootAside(page))).toBeGreaterThan(1),
  )
  const heights = [...(await savedHeights()).values()]
  expect(heights.length).toBe(1)
  expect(heights[0].reduce((high, height) => Math.max(high, height))).toBeGreaterThan(1)
  expect(heights[0].reduce((low, height) => Math.min(low, height))).toBe(0)
})

test('undo removes the stroke completely, and redo brings it back', async () => {
  await button(page, 'Undo').click()
  expect(await button(page, 'Undo').isDisabled()).toBe(true)
  expect((await savedHeights()).size).toBe(0)
  await chooseTool(page, 'Select')
  await expectPicture(page, before)
  await button(page, 'Redo').click()
  expect((await savedHeights()).size).toBe(1)
  await button(page, 'Undo').click()
})

test('Escape cancels a stroke in progress', async () => {
  await chooseTool(page, 'Sculpt')
  await stroke()
  await page.keyboard.press('Escape')
  await page.mouse.up()
  await eventually(async () => expect(await button(page, 'Undo').isDisabled()).toBe(true))
  expect((await savedHeights()).size).toBe(0)
})

test('the sculpted heights of a layer can be reset in one step', async () => {
  await stroke()
  await page.mouse.up()
  await undoIs(page, 'Sculpt')
  await page.getByRole('tab', { name: 'Maps', exact: true }).click()
  await page.locator('details.layer > summary', { hasText: 'sculpted' }).click()
  await button(page, 'Reset sculpting').click()
  await button(page, 'Reset sculpting').waitFor({ state: 'detached' })
  expect((await savedHeights()).size).toBe(0)
  await button(page, 'Undo').click()
  await button(page, 'Reset sculpting').waitFor()
})
