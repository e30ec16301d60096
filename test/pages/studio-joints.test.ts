/** Tests automatic wrinkles from joints, poses as buttons, and the skeleton that the user drags. */

import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { driversOf } from 'furrow'
import { decodeGlb, parseWrinkledFile } from 'furrow-files'
import type { Locator, Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { skinFile } from '../skin-file.ts'
import { RIGS, skeletonOf } from '../unit/author/auto/limbs/rigs.ts'
import { sleeve } from '../unit/author/auto/limbs/sleeve.ts'
import { torso } from '../unit/author/auto/limbs/torso.ts'
import { openStudio } from './opened-studio.ts'
import {
  areaChoice,
  areaNames,
  button,
  DRAWING,
  dropPaths,
  eventually,
  expectValue,
  exportFile,
  GUIDE_SIZES,
  meanPngDifference,
  savePictures,
  shootAside,
  slider,
  undoIs,
  undoLabel,
} from './studio-page.ts'

const FIGURE = fileURLToPath(new URL('../../faces/body.glb', import.meta.url))
const AREA = 'LeftForeArm flexion'
const MADE = 'Make automatic wrinkles'

const studio = openStudio({ width: 1280, height: 800 }, async (folder) => {
  const write = (name: string, bytes: Uint8Array) => writeFileSync(join(folder, name), bytes)
  write('arm.glb', await skinFile(sleeve(), { mesh: 'Arm', material: 'Shell' }))
  const body = { ...torso(), skeleton: { ...torso().skeleton!, joints: skeletonOf(RIGS.Mixamo!).joints } }
  for (const [name, isLying] of [
    ['standing.glb', false],
    ['lying.glb', true],
  ] as const)
    write(name, await skinFile(body, { mesh: 'Body', material: 'Robot', isLying }))
})
let page: Page

beforeAll(async () => {
  ;({ page } = studio)
  await dropPaths(page, [join(studio.folder, 'arm.glb')], 'Arm')
})

const drop = (name: string, title: string) => dropPaths(page, [join(studio.folder, name)], title)
const activation = async () => Number(await slider(page, AREA).inputValue())
const handle = (name: string) => page.getByRole('group', { name: 'Skeleton' }).getByRole('button', { name })

test('a mesh that nothing tells apart is folded as the user says, in one step', async () => {
  const bar = page.getByRole('region', { name: 'Expressions' })
  await bar.getByText('Its joints can fold this mesh. What is it?').waitFor(DRAWING)
  expect(await areaNames(page)).toEqual([])
  await bar.getByRole('button', { name: 'Cloth', exact: true }).click()
  await areaChoice(page, AREA).waitFor(DRAWING)
  await undoIs(page, MADE)
  expect(await page.getByRole('radio', { name: 'Cloth' }).isChecked()).toBe(true)
  expect(await page.getByLabel('Fabric').inputValue()).toBe('shirt')
})

test('a pose button, a key and a slider fold the elbow, and the rest pose restores it', async () => {
  const rest = await shootAside(page)
  expect(await activation()).toBe(0)
  await button(page, 'Bend left elbow').click()
  await expectValue(slider(page, AREA), 0.83)
  expect(await meanPngDifference(rest, await shootAside(page))).toBeGreaterThan(1)
  await page.keyboard.press('1')
  await expectValue(slider(page, AREA), 0)
  expect(await button(page, 'Rest pose').getAttribute('aria-pressed')).toBe('true')
  expect(await meanPngDifference(rest, await shootAside(page))).toBeLessThan(0.5)
  await page.keyboard.press('2')
  await expectValue(slider(page, AREA), 0.83)
  await button(page, 'Sliders').click()
  await slider(page, 'Bend left elbow').fill('0')
  await expectValue(slider(page, AREA), 0)
  await button(page, 'Sliders').click()
})

test('pointing at a region bends the joint, and leaving it restores the pose', async () => {
  await areaChoice(page, AREA).locator('..').hover()
  await eventually(async () => expect(await activation()).toBeGreaterThan(0.5))
  await page.mouse.move(640, 10)
  await expectValue(slider(page, AREA), 0)
})

test('a bone turns towards the pointer and by arrow keys, and the folds follow', async () => {
  await button(page, 'Skeleton').click()
  const end = handle('Elbow, left').first()
  const { x, y, width, height } = await restingBox(end)
  const [startX, startY] = [x + width / 2, y + height / 2]
  await page.mouse.move(startX, startY)
  await page.mouse.down()
  await page.mouse.move(startX - 40, startY - 120, { steps: 4 })
  await page.mouse.up()
  await eventually(async () => {
    const moved = (await end.boundingBox())!
    expect(moved.y).toBeLessThan(y - 20)
  })
  expect(await undoLabel(page)).toBe(MADE)
  await page.locator('.skeleton-hint').getByRole('button', { name: 'Rest pose' }).click()
  await eventually(async () => expect((await end.boundingBox())!.y).toBeCloseTo(y, 0))
  await end.focus()
  await page.keyboard.press('Shift+ArrowLeft')
  await eventually(async () => expect((await end.boundingBox())!.y).toBeLessThan(y - 5))
  await page.keyboard.press('ArrowUp')
  expect(await handle('Upper arm, left').first().getAttribute('tabindex')).toBe('0')
  // Seen from above, the elbow bends forwards, which is downwards on the screen.
  await page.locator('.skeleton-hint').getByRole('button', { name: 'Rest pose' }).click()
  await page.locator('#viewport').focus()
  for (let i = 0; i < 14; i++) await page.keyboard.press('ArrowUp')
  await end.focus()
  await eventually(async () => {
    await page.keyboard.press('Shift+ArrowRight')
    expect(await activation()).toBeGreaterThan(0.5)
  })
  await page.locator('.skeleton-hint').getByRole('button', { name: 'Rest pose' }).click()
  await button(page, 'Skeleton').click()
  expect(await page.locator('.skeleton').isVisible()).toBe(false)
})

test('undo removes the folds at once, and the exported file has them with their joints', async () => {
  await button(page, 'Undo').click()
  await eventually(async () => expect(await areaNames(page)).toEqual([]))
  await button(page, 'Redo').click()
  await areaChoice(page, AREA).waitFor(DRAWING)
  const download = await exportFile(page)
  const glb = decodeGlb(new Uint8Array(readFileSync((await download.path())!)), 'arm.glb', 'test')
  const { maps } = parseWrinkledFile(glb, 0, 'test')
  expect(maps.areas.map(({ name }) => name)).toContain(AREA)
  const bones = driversOf('bone', maps.drivers).filter(({ area }) => area === AREA)
  expect(bones.map(({ joints }) => joints[1])).toContain('LeftForeArm')
})

test('a body that lies flat in its file stands upright, and joints do not fold a hard one', async () => {
  await drop('standing.glb', 'Standing')
  await page.getByText('because it looks hard').waitFor(DRAWING)
  const standing = await shootAside(page)
  await drop('lying.glb', 'Lying')
  await page.getByText('because it looks hard').waitFor(DRAWING)
  expect(await meanPngDifference(standing, await shootAside(page))).toBeLessThan(0.5)
})

test('the chosen mesh is in the picture, and its poses fold it', async () => {
  await dropPaths(page, [FIGURE], 'Body')
  await page.getByLabel('Wrinkles on').selectOption('shirt')
  await slider(page, 'spine01 forward').waitFor(DRAWING)
  await page.getByRole('button', { name: 'Front', pressed: false }).waitFor()
  await button(page, 'Bend forward').click()
  await eventually(async () =>
    expect(Number(await slider(page, 'spine01 forward').inputValue())).toBeGreaterThan(0.5),
  )
  expect(Number(await page.getByRole('slider', { name: /^Divider/ }).getAttribute('aria-valuenow'))).toBe(30)
  await savePictures(page, 'pose', GUIDE_SIZES)
  await button(page, 'Skeleton').click()
  await savePictures(page, 'skeleton', GUIDE_SIZES)
})

/** Returns the place of a handle once it rests. The camera may still move from the view of a pose. */
async function restingBox(handle: Locator) {
  let last = (await handle.boundingBox())!
  await eventually(async () => {
    await page.waitForTimeout(500)
    const [before, now] = [last, (await handle.boundingBox())!]
    last = now
    expect(now).toEqual(before)
  })
  return last
}
