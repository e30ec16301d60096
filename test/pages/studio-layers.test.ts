/** Tests layers in the studio: names, order, importing and saving maps, blood maps, and baking a sculpted mesh. */

import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Page } from 'playwright-core'
import sharp from 'sharp'
import { beforeAll, expect, test } from 'vitest'
import { readDocument } from '../../studio/src/export/read-document.ts'
import { openStudio } from './opened-studio.ts'
import {
  addImages,
  blackPng,
  button,
  dismiss,
  drop,
  dropPlain,
  eventually,
  expectPicture,
  exportFile,
  shootAside,
  showSliders,
  showTab,
  slider,
  undoIs,
  undoLabel,
} from './studio-page.ts'

const studio = openStudio({ width: 1100, height: 640 })
const { folder } = studio
let page: Page

beforeAll(async () => {
  ;({ page } = studio)
  await dropPlain(page, folder, 'foreheadInnerLeft')
})

test('layers can be added, renamed, moved and undone; a map can be imported, and saved as an image', async () => {
  await showTab(page, 'Maps')
  await button(page, 'New layer').click()
  await page.locator('.layer summary', { hasText: 'layer' }).click()
  await page.getByLabel('Name of layer layer').fill('sweat')
  await page.keyboard.press('Enter')
  const layerNames = () => page.locator('.layer summary').allInnerTexts()
  const first = (await layerNames())[0]
  while (await button(page, 'Move sweat up').isEnabled()) await button(page, 'Move sweat up').click()
  await eventually(async () => expect((await layerNames())[0]).toMatch(/^sweat/))
  const gray = await sharp({ create: { width: 64, height: 64, channels: 3, background: '#808080' } })
    .png()
    .toBuffer()
  const input = page.getByLabel('Import roughness of sweat')
  await input.setInputFiles({ name: 'wet.png', mimeType: 'image/png', buffer: gray })
  await eventually(() => expect(button(page, 'Save roughness of sweat').isEnabled()).resolves.toBe(true))
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    button(page, 'Save roughness of sweat').click(),
  ])
  expect(download.suggestedFilename()).toBe('plain-sweat-roughness.png')
  // The saved map has the size of the other maps.
  expect(await sharp(await download.path()).metadata()).toMatchObject({
    width: 1024,
    height: 1024,
    format: 'png',
  })
  await input.setInputFiles({ name: 'notes.png', mimeType: 'image/png', buffer: Buffer.from('no image') })
  await dismiss(page, 'notes.png')
  while (await button(page, 'Undo').isEnabled()) await button(page, 'Undo').click()
  await eventually(async () => expect((await layerNames())[0]).toBe(first))
  expect(await layerNames()).not.toContain('sweat')
})

test('a dropped image is recognised by its name, and becomes a map of the first layer', async () => {
  await drop(page, 'skin_normal.png', await blackPng())
  const dialog = page.getByRole('dialog', { name: 'What is this image?' })
  await eventually(async () => expect(await dialog.getByLabel('Normal map').isChecked()).toBe(true))
  await addImages(page)
  await eventually(async () => expect(await undoLabel(page)).toMatch(/^Import normal of/))
  await button(page, 'Undo').click()
})

test('regions can have more texels, and the code beside Export names their number', async () => {
  const size = page.getByLabel('Region size')
  await size.selectOption('256')
  await undoIs(page, 'Change the size of regions to 256')
  await exportFile(page)
  await button(page, 'Exported file').click()
  const code = page.getByRole('textbox', { name: 'Code that loads the file' })
  await eventually(async () => expect(await code.inputValue()).toContain('areaSize: 256'))
  await page.keyboard.press('Escape')
  await button(page, 'Undo').click()
  await eventually(async () => expect(await size.inputValue()).toBe('128'))
})

test('an imported blood map reddens or pales the skin where an area shows, and is exported', async () => {
  await showSliders(page)
  await page.locator('#filter').fill('browInnerUp')
  await slider(page, 'browInnerUp').fill('1')
  const before = await shootAside(page)
  const redness = async (picture: Buffer) => {
    const [red, green] = (await sharp(picture).stats()).channels
    return red.mean - green.mean
  }
  const inputs = page.getByLabel(/^Import blood of/)
  const importAll = async (background: string) => {
    const gray = sharp({ create: { width: 64, height: 64, channels: 3, background } })
    const file = { name: 'blood.png', mimeType: 'image/png', buffer: await gray.png().toBuffer() }
    for (let i = 0; i < (await inputs.count()); i++) {
      await inputs.nth(i).setInputFiles(file)
      const name = (await inputs.nth(i).getAttribute('aria-label'))!.replace('Import ', '')
      await undoIs(page, `Import ${name}`)
    }
  }
  const reddens = async (least: number, most: number) =>
    eventually(async () => {
      const change = (await redness(await shootAside(page))) - (await redness(before))
      expect(change).toBeGreaterThan(least)
      expect(change).toBeLessThan(most)
    })
  await importAll('#000')
  await reddens(-255, -0.05)
  for (let i = 0; i < (await inputs.count()); i++) await button(page, 'Undo').click()
  await expectPicture(page, before)
  await importAll('#fff')
  await reddens(0.05, 255)
  const file = await exportFile(page)
  const document = await readDocument({ name: 'face.glb', bytes: readFileSync(await file.path()) })
  for (const { maps } of document!.layers) {
    const [{ min }] = (await sharp(maps.blood!.bytes).stats()).channels
    expect(min).toBe(255)
  }
  while (await button(page, 'Undo').isEnabled()) await button(page, 'Undo').click()
  await slider(page, 'browInnerUp').fill('0')
  await page.locator('#filter').fill('')
})

test('a sculpted mesh is baked into a layer, and baking can be cancelled', async () => {
  const [layer] = await page.locator('.layer summary').allInnerTexts()
  await page.locator('.layer summary').first().click()
  const sculpt = page.getByLabel(/^Bake a sculpt into/).first()
  await sculpt.setInputFiles(join(folder, 'plain.glb'))
  await button(page, 'Close').last().click()
  expect(await button(page, 'Undo').isDisabled()).toBe(true)
  await sculpt.setInputFiles(join(folder, 'broken.glb'))
  await dismiss(page, 'broken.glb')
  await sculpt.setInputFiles(join(folder, 'plain.glb'))
  await undoIs(page, 'Bake plain.glb')
  expect((await page.locator('.layer summary').allInnerTexts())[0]).not.toBe(layer)
  await button(page, 'Undo').click()
})
