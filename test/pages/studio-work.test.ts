/** Tests an artist's main steps in the studio: open an avatar, make wrinkles, change them, reload the page, and export. */

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { strFromU8, unzipSync } from 'fflate'
import type { Page } from 'playwright-core'
import sharp from 'sharp'
import { beforeAll, expect, test, vi } from 'vitest'
import { writePlain } from './avatars.ts'
import { openStudio } from './opened-studio.ts'
import { runFurrow } from './run-furrow.ts'
import {
  areaNames,
  dropPaths,
  expectValue,
  exportFile,
  meanPngDifference,
  saveProject,
  shootStage,
  slider,
  waitUntilReady,
} from './studio-page.ts'

const studio = openStudio({ width: 1000, height: 560 }, writePlain)
const { folder } = studio
let page: Page

beforeAll(async () => {
  ;({ page } = studio)
  await page.getByRole('slider', { name: /^Divider/ }).press('Home')
})

const age = () => page.getByRole('slider', { name: 'Age' })
const areas = () => areaNames(page)
/** Waits until the page no longer shows that wrinkles are being made. */
const waitForWrinkles = () => page.getByText('Making wrinkles').waitFor({ state: 'detached' })
const waitForAreas = (names: string[]) =>
  vi.waitFor(async () => expect(await areas()).toEqual(names), { timeout: 300_000 })

let names: string[]
let surprised: Buffer

test('an avatar without wrinkles gets them, and its forehead creases', async () => {
  await dropPaths(page, [join(folder, 'plain.glb')], 'Plain')
  await page.locator('#areas .row').first().waitFor()
  await waitForWrinkles()
  names = await areas()
  expect(names).toContain('foreheadInnerLeft')
  await page.getByRole('button', { name: 'Surprised', exact: true }).click()
  const forehead = slider(page, 'foreheadInnerLeft')
  await expect.poll(async () => Number(await forehead.inputValue()), { timeout: 60_000 }).toBeGreaterThan(0.9)
  const divider = page.getByRole('slider', { name: /^Divider/ })
  surprised = await shootStage(page)
  await divider.press('End')
  expect(await meanPngDifference(surprised, await shootStage(page))).toBeGreaterThan(0.05)
  await divider.press('Home')
})

test('another age changes the wrinkles, and undo restores the old ones', async () => {
  await age().press('End')
  await expect
    .poll(() => page.getByRole('button', { name: 'Undo' }).isEnabled(), { timeout: 300_000 })
    .toBe(true)
  await waitForWrinkles()
  const apart = async () => meanPngDifference(surprised, await shootStage(page))
  await expect.poll(apart, { timeout: 60_000 }).toBeGreaterThan(0.02)
  await page.keyboard.press('Control+z')
  await expectValue(age(), 45)
  await waitForAreas(names)
  await vi.waitFor(
    async () => expect(await meanPngDifference(surprised, await shootStage(page))).toBeLessThan(0.02),
    { timeout: 300_000 },
  )
  await page.keyboard.press('Control+Shift+z')
  await expectValue(age(), 80)
})

test('a reload continues with the work', async () => {
  await page.getByText('Kept in this browser').waitFor()
  // At this age, the face also has areas of bulges.
  await expect.poll(async () => (await areas()).length).toBeGreaterThan(names.length)
  const before = await areas()
  await page.reload()
  await waitUntilReady(page)
  await waitForAreas(before)
  await expectValue(age(), 80)
})

test('the export equals what furrow pack makes of the saved project, and is valid', async () => {
  const face = await exportFile(page)
  const project = await saveProject(page)
  const exported = readFileSync(await face.path())
  for (const [path, bytes] of Object.entries(unzipSync(readFileSync(await project.path())))) {
    mkdirSync(dirname(join(folder, path)), { recursive: true })
    writeFileSync(join(folder, path), bytes)
  }
  const wrinkles = readFileSync(join(folder, 'plain/strokes.json'))
  expect(JSON.parse(strFromU8(wrinkles)).strokes.length).toBeGreaterThan(20)
  const packed = await runFurrow(folder, {}, 'pack', 'plain', '-o', 'packed.glb')
  expect(packed.stderr).toBe('')
  expect(readFileSync(join(folder, 'packed.glb')).equals(exported)).toBe(true)
  const { code, stdout } = await runFurrow(folder, {}, 'validate', 'packed.glb')
  expect({ code, stdout }).toEqual({ code: 0, stdout: 'packed.glb: 0 errors, 0 warnings\n' })
})

test("the export's maps and heights equal those of furrow auto with the same options", async () => {
  const settings = ['--age', '80', '--size', '1024']
  await runFurrow(folder, {}, 'auto', 'plain.glb', '-o', 'auto.glb', ...settings)
  await runFurrow(folder, {}, 'unpack', 'auto.glb', '-o', 'auto')
  const levels = (path: string) => sharp(join(folder, path)).toColourspace('b-w').raw().toBuffer()
  const { layers } = JSON.parse(readFileSync(join(folder, 'plain/wrinkles.json'), 'utf8'))
  const made = JSON.parse(readFileSync(join(folder, 'auto/wrinkles.json'), 'utf8')).layers
  expect(layers.length).toBe(made.length)
  for (const [i, layer] of made.entries()) {
    expect(layers[i].heightAmplitude).toBeCloseTo(layer.heightAmplitude, 9)
    for (const map of ['normal', 'occlusion', 'height']) {
      const [own, other] = await Promise.all([
        levels(`plain/${layers[i][map]}`),
        levels(`auto/${layer[map]}`),
      ])
      expect(own.equals(other), `${layer.name} ${map}`).toBe(true)
    }
  }
})
