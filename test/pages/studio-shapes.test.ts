/** Tests the recognition of blendshapes without meaningful names, an artist's corrections, and their export. */

import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Locator, Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { io, plainHuman } from './avatars.ts'
import { openStudio } from './opened-studio.ts'
import {
  areaChoice,
  button,
  DRAWING,
  dropPaths,
  eventually,
  expectPicture,
  exportFile,
  meanPngDifference,
  shootAside,
  shootStage,
  showTab,
  undoIs,
  waitUntilReady,
} from './studio-page.ts'

const studio = openStudio({ width: 1120, height: 700 }, async (folder) => {
  const document = await plainHuman()
  const meshes = document.getRoot().listMeshes()
  const skin = meshes.find((mesh) => mesh.listPrimitives()[0]!.listTargets().length > 50)!
  names = skin.getExtras().targetNames as string[]
  for (const mesh of meshes) {
    mesh.setExtras({})
    for (const target of mesh.listPrimitives().flatMap((each) => each.listTargets())) target.setName('')
  }
  writeFileSync(join(folder, 'nameless.glb'), await io.writeBinary(document))
})
let page: Page
/** Original names of the blendshapes. */
let names: string[]

beforeAll(async () => {
  ;({ page } = studio)
  await dropPaths(page, [join(studio.folder, 'nameless.glb')], 'Nameless')
  await made()
})

const made = async () => {
  await page.getByRole('tab', { name: 'When' }).waitFor(DRAWING)
  await eventually(async () => expect(await page.getByText('Making wrinkles').count()).toBe(0))
}
const rows = () => page.locator('.shape:visible')
const rowOf = (name: string): Locator => rows().filter({ has: choiceOf(name) })
const choiceOf = (name: string) => page.getByRole('combobox', { name: `What ${name} is`, exact: true })
const indexOf = (shape: string) => String(names.indexOf(shape))
const noteOf = () => page.getByText('The wrinkles were made before the last corrections.')

async function unfold(): Promise<void> {
  await showTab(page, 'When')
  await page.getByRole('heading', { name: 'Recognised blendshapes', exact: true }).click()
  await rows().first().waitFor(DRAWING)
}

async function correct(name: string, shape: string): Promise<void> {
  await choiceOf(name).focus()
  await choiceOf(name).selectOption(shape)
}

test('the unfolded section lists the blendshapes by what they move', async () => {
  await unfold()
  expect(await rows().count()).toBe(names.length)
  const row = rowOf(indexOf('mouthSmileLeft'))
  expect(await row.textContent()).toMatch(/\d\d%motion/)
  expect(await row.locator('option:checked').textContent()).toBe('mouthSmileLeft (automatic)')
  // The blendshape of the tongue moves no skin, so its meaning is unknown.
  await page.getByLabel('Unknown only').check()
  expect(await rows().count()).toBe(1)
  expect(await rows().textContent()).toContain('unknown')
  await page.getByLabel('Unknown only').uncheck()
  await page.getByLabel('Filter shapes').fill('browOuter')
  expect(await rows().count()).toBe(2)
  await page.getByLabel('Filter shapes').fill('')
})

test('the face shows the hovered or focused blendshape', async () => {
  const before = await shootAside(page)
  const name = indexOf('jawOpen')
  const show = page.getByRole('button', { name, exact: true })
  await show.scrollIntoViewIfNeeded()
  const { x, y } = (await show.boundingBox())!
  await page.mouse.move(x + 20, y + 10)
  await page.mouse.move(x + 24, y + 12)
  await eventually(async () =>
    expect(await meanPngDifference(before, await shootStage(page))).toBeGreaterThan(1),
  )
  const shown = await shootStage(page)
  await expectPicture(page, before)
  await choiceOf(name).focus()
  await eventually(async () => expect((await shootStage(page)).equals(shown)).toBe(true))
  await choiceOf(name).blur()
  await expectPicture(page, before)
})

test('a correction can be undone and redone, and changes wrinkles when the artist asks', async () => {
  const name = indexOf('noseSneerLeft')
  await correct(name, '-')
  await undoIs(page, `Correct ${name}`)
  expect(await rowOf(name).textContent()).toContain('corrected')
  await noteOf().waitFor()
  await button(page, 'Undo').click()
  await noteOf().waitFor({ state: 'detached' })
  const label = rowOf(name).locator('option:checked')
  await eventually(async () => expect(await label.textContent()).toBe('noseSneerLeft (automatic)'))
  await button(page, 'Redo').click()
  await noteOf().waitFor()
  expect(await areaChoice(page, 'noseLeft').count()).toBe(1)
  await button(page, 'Make them again').click()
  await noteOf().waitFor({ state: 'detached' })
  await made()
  // After the correction no blendshape wrinkles the left side of the nose.
  await eventually(async () => expect(await areaChoice(page, 'noseLeft').count()).toBe(0))
  expect(await areaChoice(page, 'mouthCornerLeft').count()).toBe(1)
})

test('the browser stores two corrections', async () => {
  await correct(indexOf('mouthSmileLeft'), 'mouthFrownLeft')
  await page.getByText('Kept in this browser').waitFor()
  await page.reload()
  await waitUntilReady(page)
  await made()
  await unfold()
  await expectCorrections()
  await noteOf().waitFor()
})

test('the exported file contains the corrections', async () => {
  const download = await exportFile(page)
  const path = join(studio.folder, 'exported.glb')
  writeFileSync(path, readFileSync(await download.path()))
  const length = readFileSync(path).readUInt32LE(12)
  const json = JSON.parse(
    readFileSync(path)
      .subarray(20, 20 + length)
      .toString(),
  )
  const [extension] = json.materials.flatMap((material: { extensions?: Record<string, unknown> }) => {
    return material.extensions?.FURROW_wrinkle_maps ?? []
  })
  expect(extension.shapes).toEqual([
    { mesh: expect.any(String), target: indexOf('mouthSmileLeft'), shape: 'mouthFrownLeft' },
    { mesh: expect.any(String), target: indexOf('noseSneerLeft') },
  ])
  await dropPaths(page, [path], 'Exported')
  await button(page, 'Edit wrinkles').click()
  await unfold()
  await expectCorrections()
})

async function expectCorrections(): Promise<void> {
  expect(await choiceOf(indexOf('mouthSmileLeft')).inputValue()).toBe('mouthFrownLeft')
  expect(await choiceOf(indexOf('noseSneerLeft')).inputValue()).toBe('-')
}
