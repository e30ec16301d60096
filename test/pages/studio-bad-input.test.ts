/** Tests that the studio reports invalid files and a full disk in one line, and that work continues. */

import { closeSync, openSync, readFileSync, truncateSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { editGlb } from '../glb.ts'
import { openStudio } from './opened-studio.ts'
import { sheet } from './sheet.ts'
import { areaNames, dismiss, dropPaths } from './studio-page.ts'

const SOON = { timeout: 60_000 }
const studio = openStudio({ width: 1000, height: 560 })
let page: Page
const at = (name: string) => join(studio.folder, name)
const button = (name: string | RegExp) => page.getByRole('button', { name })
const note = (text: string) => page.getByRole('status').getByText(text).waitFor()
const areas = () => areaNames(page)

beforeAll(async () => {
  page = studio.page
  const plain = readFileSync(at('plain.glb'))
  const write = (name: string, change: (primitive: { targets?: unknown; attributes: object }) => void) => {
    const edited = editGlb(plain, (json) => {
      for (const mesh of json.meshes) {
        mesh.weights = undefined
        mesh.extras = undefined
        mesh.primitives.forEach(change)
      }
    })
    writeFileSync(at(name), edited)
  }
  write('still.glb', (primitive) => {
    primitive.targets = undefined
  })
  write('unwrapped.glb', (primitive) => {
    primitive.attributes = { ...primitive.attributes, TEXCOORD_0: undefined }
  })
  writeFileSync(at('sheet.glb'), await sheet(20))
  writeFileSync(at('millions.glb'), await sheet(1001))
  writeFileSync(at('large.glb'), plain)
  truncateSync(at('large.glb'), 600 * 2 ** 20)
  closeSync(openSync(at('empty.glb'), 'w'))
})

// Runs first, because Chromium applies a changed quota only while nothing is stored.
test('a full disk keeps the work in memory, and saves it once there is room', async () => {
  const session = await page.context().newCDPSession(page)
  const { origin } = new URL(page.url())
  await session.send('Storage.overrideQuotaForOrigin', { origin, quotaSize: 1000 })
  await dropPaths(page, [at('plain.glb')], 'Plain')
  await expect.poll(async () => (await areas()).length, { timeout: 300_000 }).toBeGreaterThan(5)
  await button('New region').click()
  await page.getByText('the browser has no room left for this project; free some disk space').waitFor()
  await expect.poll(areas, SOON).toContain('area')
  await session.send('Storage.overrideQuotaForOrigin', { origin })
  await page.getByText('Kept in this browser').waitFor()
})

test('an avatar without blendshapes is reported, and can be painted', async () => {
  await dropPaths(page, [at('still.glb')], 'Still')
  await note('has no blendshapes: it can be painted, but no expression moves it')
  await page.locator('#poses').getByText('This avatar has no blendshapes.').waitFor()
  expect(await page.locator('#poses button').count()).toBe(0)
  await button('New region').click()
  await expect.poll(areas, SOON).toEqual(['area'])
})

test('an avatar without texture coordinates is reported', async () => {
  await dropPaths(page, [at('unwrapped.glb')], 'Unwrapped')
  await note('it has no texture coordinates: unwrap it, and export it again')
  await page.locator('#inspector').getByText('cannot wrinkle: it has no texture coordinates').waitFor()
  expect(await page.getByRole('toolbar', { name: 'Tools' }).getByRole('button').count()).toBe(1)
})

test('a model that is no face is reported, and can be painted', async () => {
  await dropPaths(page, [at('sheet.glb')])
  await page
    .getByRole('alert')
    .getByText(/no wrinkles can be made|autoWrinkles/)
    .waitFor()
  await button('Dismiss').click()
  await button('New region').click()
  await expect.poll(areas, SOON).toEqual(['area'])
})

test('an oversized file is reported without being read', async () => {
  await dropPaths(page, [at('large.glb')])
  await dismiss(page, 'large.glb is too large, got "600 MiB", allowed: 512 MiB')
})

test('an empty file is reported', async () => {
  await dropPaths(page, [at('empty.glb')])
  await dismiss(page, 'empty.glb is not usable')
})

test('two million triangles are shown, with a warning', async () => {
  await dropPaths(page, [at('millions.glb')], 'Millions')
  await note('it has 2,004,002 triangles, more than 2,000,000: decimate it')
})
