/** Checks that tests on WebGL and on WebGPU share: they use the studio with the shipped face. */

import type { Page } from 'playwright-core'
import sharp from 'sharp'
import { expect } from 'vitest'
import {
  brightnessDeviation,
  button,
  chooseLook,
  expectValue,
  meanPngDifference,
  shootStage,
  showSliders,
  slider,
} from './studio-page.ts'

/** Expects a different picture for each look of the skin, and the first picture again at the end. */
export async function showsLooks(page: Page, backend: string): Promise<void> {
  expect(await page.textContent('#backend')).toBe(backend)
  expect(await page.textContent('#adapter')).not.toBe('')
  const shaded = await shootStage(page)
  expect(await brightnessDeviation(shaded)).toBeGreaterThan(30)
  for (const look of ['Normals', 'Regions', 'Wires']) {
    await chooseLook(page, look)
    expect(await meanPngDifference(shaded, await shootStage(page)), look).toBeGreaterThan(2)
  }
  await chooseLook(page, 'Regions')
  const all = await shootStage(page)
  await page.getByLabel('Region', { exact: true }).selectOption('nose')
  expect(await meanPngDifference(all, await shootStage(page)), 'one area').toBeGreaterThan(0.5)
  await page.keyboard.press('Escape')
  await chooseLook(page, 'Shaded')
  expect(await meanPngDifference(shaded, await shootStage(page)), 'shaded again').toBe(0)
}

/** Expects that expressions and sliders move the face, and that drivers activate the areas. */
export async function movesFace(page: Page): Promise<void> {
  await showSliders(page)
  await button(page, 'Surprised').click()
  const surprised = await shootStage(page)
  await page.getByRole('button', { name: 'Happy' }).click()
  await expectValue(slider(page, 'crowsFeetLeft'), 1)
  await expectValue(slider(page, 'foreheadLeft'), 0)
  const happy = await shootStage(page)
  expect(await meanPngDifference(surprised, happy)).toBeGreaterThan(0.2)

  await slider(page, 'foreheadLeft').fill('1')
  const creased = await shootStage(page)
  expect(await meanPngDifference(happy, creased)).toBeGreaterThan(0.01)
  const filter = page.getByLabel('Filter blendshapes')
  await filter.fill('jawOpen')
  await slider(page, 'jawOpen').fill('0.6')
  expect(await meanPngDifference(creased, await shootStage(page))).toBeGreaterThan(0.2)
  // One blendshape at 0.8 drives the area, through a linear curve from 0.15 to 1.
  await filter.fill('browOuterUpRight')
  await slider(page, 'browOuterUpRight').fill('1')
  await expectValue(slider(page, 'foreheadRight'), (0.8 - 0.15) / 0.85)
  await expectValue(slider(page, 'foreheadLeft'), 1)

  await page.getByRole('button', { name: 'Reset all regions' }).click()
  await expectValue(slider(page, 'crowsFeetLeft'), 0)
  await page.getByRole('button', { name: 'Surprised' }).click()
  await expectValue(slider(page, 'jawOpen'), 0.25)
  await filter.fill('')
  expect(await meanPngDifference(surprised, await shootStage(page)), 'surprised again').toBe(0)
}

async function savePicture(page: Page): Promise<void> {
  await button(page, 'Share').click()
  await page.getByRole('button', { name: 'Save picture' }).click()
}

/** Expects that the saved picture equals the stage. */
export async function savesPicture(page: Page): Promise<void> {
  const [download] = await Promise.all([page.waitForEvent('download'), savePicture(page)])
  expect(download.suggestedFilename()).toMatch(/^furrow-human-.*\.png$/)
  const file = await download.path()
  const { format, width } = await sharp(file).metadata()
  expect(format).toBe('png')
  expect(width).toBe(await page.evaluate(() => document.querySelector('canvas')!.width))
  expect(await brightnessDeviation(await sharp(file).toBuffer())).toBeGreaterThan(30)
}
