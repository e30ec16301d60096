/** Tests the studio on WebGPU, and switching back to WebGL. `studio.test.ts` makes the same checks on WebGL. */

import { expect, test } from 'vitest'
import { openStudio } from './opened-studio.ts'
import { movesFace, savesPicture, showsLooks } from './studio-face.ts'
import {
  brightnessDeviation,
  expectValue,
  prefer,
  shootStage,
  slider,
  waitUntilReady,
} from './studio-page.ts'

const studio = openStudio({ width: 1000, height: 560 })

test('switching to WebGPU keeps the settings', async () => {
  const { page } = studio
  await page.getByRole('button', { name: 'Surprised' }).click()
  await slider(page, 'glabella').fill('0.7')
  await prefer(page, 'Renderer', 'WebGPU')
  await waitUntilReady(page, 'WebGPU')
  await expectValue(slider(page, 'glabella'), 0.7)
  await expectValue(slider(page, 'foreheadLeft'), 1)
})

test('every look shows the face', () => showsLooks(studio.page, 'WebGPU'))

test('expressions and sliders move the face', () => movesFace(studio.page))

test('the picture is saved as a PNG', () => savesPicture(studio.page))

test('switching back to WebGL shows the same as before', async () => {
  const { page } = studio
  await prefer(page, 'Renderer', 'WebGL')
  await waitUntilReady(page, 'WebGL 2')
  await expectValue(slider(page, 'foreheadLeft'), 1)
  expect(await brightnessDeviation(await shootStage(page))).toBeGreaterThan(30)
})
