import { copyFileSync, existsSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { openStudio } from './opened-studio.ts'
import {
  addImages,
  brightnessDeviation,
  dismiss,
  dropPaths,
  expectValue,
  meanPngDifference,
  projectCard,
  shootPlainHuman,
  shootStage,
  showSliders,
  slider,
  waitUntilReady,
} from './studio-page.ts'

const SCAN = fileURLToPath(new URL('../../../shared/real-face/ict-face.glb', import.meta.url))

const studio = openStudio({ width: 1000, height: 560 })
const { folder } = studio
let page: Page
/** Picture of the shipped face at rest without wrinkles. Avatars made from this face must look the same. */
let human: Buffer

beforeAll(async () => {
  ;({ page } = studio)
  await showSliders(page)
  human = await shootPlainHuman(page)
})

test.each([
  ['a .glb', 'plain.glb', 'Plain'],
  ['a VRM that looks along -Z', 'turned.vrm', 'Turned'],
])('%s is shown when dropped, framed at the face', async (_, path, name) => {
  await dropPaths(page, [join(folder, path)], name)
  expect(await meanPngDifference(human, await shootStage(page))).toBeLessThan(1)
})

test('a dropped avatar without wrinkles moves by expressions, including its own', async () => {
  await page.getByRole('button', { name: 'Surprised' }).click()
  await page.getByLabel('Filter blendshapes').fill('jawOpen')
  await expectValue(slider(page, 'jawOpen'), 0.25)
  expect(await meanPngDifference(human, await shootStage(page))).toBeGreaterThan(0.2)
  await page.getByRole('button', { name: 'Yawn' }).click()
  await expectValue(slider(page, 'jawOpen'), 0.75)
  await page.getByRole('button', { name: 'Neutral' }).click()
})

test.each([
  ['a broken file', 'broken.glb', 'Studio: broken.glb is not usable: it is truncated'],
  ['a format that is not glTF', 'model.fbx', 'Studio: model.fbx is not usable: it is an FBX file'],
  ['a .gltf without its files', 'separate/avatar.gltf', 'avatar.gltf refers to a file that was not dropped'],
])('%s is refused in one line, and the avatar stays', async (_, path, text) => {
  const before = await shootStage(page)
  await dropPaths(page, [join(folder, path)])
  await dismiss(page, text)
  expect(await meanPngDifference(before, await shootStage(page))).toBe(0)
  expect(await page.locator('#face').inputValue()).toBe('turned')
})

test('a folder of wrinkles is shown on its face', async () => {
  // By now the previous avatar has automatic wrinkles.
  await expectValue(slider(page, 'foreheadInnerLeft'), 0)
  await dropPaths(page, [join(folder, 'wrinkles')], 'Face')
  await page.getByRole('slider', { name: /^Divider/ }).press('Home')
  expect(await meanPngDifference(human, await shootStage(page))).toBeLessThan(1)
  await slider(page, 'everywhere').fill('1')
  expect(await meanPngDifference(human, await shootStage(page))).toBeGreaterThan(1)
})

test('areas can be added to a folder of wrinkles', async () => {
  await page.getByRole('button', { name: 'Reset all regions' }).click()
  const before = await shootStage(page)
  const image = join(folder, 'forehead.png')
  copyFileSync(join(folder, 'wrinkles/areas/everywhere.png'), image)
  await dropPaths(page, [image])
  await addImages(page)
  await expectValue(slider(page, 'forehead'), 1)
  expect(await meanPngDifference(before, await shootStage(page))).toBeGreaterThan(1)
})

test('a face of the list is restored as it was', async () => {
  const faces = (await projectCard(page)).getByLabel('Example face')
  await faces.selectOption('human')
  await waitUntilReady(page)
  expect(await faces.locator('option').allTextContents()).not.toContain('Face')
  await page.keyboard.press('Escape')
  await page.getByRole('slider', { name: /^Divider/ }).press('End')
  expect(await meanPngDifference(human, await shootStage(page))).toBeLessThan(0.001)
})

test.skipIf(!existsSync(SCAN))(
  'a scanned face is shown from its front (skipped without ../shared/real-face)',
  async () => {
    await dropPaths(page, [SCAN], 'Ict face')
    const picture = await shootStage(page)
    expect(await brightnessDeviation(picture)).toBeGreaterThan(30)
    expect(await meanPngDifference(human, picture)).toBeGreaterThan(5)
    await page.getByRole('button', { name: 'Surprised' }).click()
    expect(await meanPngDifference(picture, await shootStage(page))).toBeGreaterThan(0.2)
  },
)
