/** What the studio does with a face, switched to WebGPU and back; on WebGL `studio.test.ts` does the same. */

import { expect, test } from 'vitest'
import { openStudio } from './opened-studio.ts'
import { movesFace, savesPicture, showsLooks } from './studio-face.ts'
import { brightnessDeviation, expectValue, shootStage, slider, waitUntilReady } from './studio-page.ts'

const studio = openStudio({ width: 800, height: 400 })

test('keeps the settings when it is switched to WebGPU', async () => {
  const { page } = studio
  await page.getByRole('button', { name: 'Surprised' }).click()
  await slider(page, 'glabella').fill('0.7')
  await page.getByText('WebGPU', { exact: true }).click()
  await waitUntilReady(page, 'WebGPU')
  await expectValue(slider(page, 'glabella'), 0.7)
  await expectValue(slider(page, 'foreheadLeft'), 1)
})

test('shows the face in every look', () => showsLooks(studio.page, 'WebGPU'))

test('moves the face by expressions and sliders', () => movesFace(studio.page))

test('saves the picture as a PNG', () => savesPicture(studio.page))

test('shows on WebGL again what it showed before', async () => {
  const { page } = studio
  await page.getByText('WebGL', { exact: true }).click()
  await waitUntilReady(page, 'WebGL 2')
  await expectValue(slider(page, 'foreheadLeft'), 1)
  expect(await brightnessDeviation(await shootStage(page))).toBeGreaterThan(30)
})
