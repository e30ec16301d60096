/** Tests the first minute with the studio: the empty stage, the performance after a drop, the hints, and a reload. */

import { join } from 'node:path'
import type { Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { dropPaths as dropOnPage } from '../../scripts/lib/drop-paths.mjs'
import { openStudio } from './opened-studio.ts'
import {
  areaChoice,
  button,
  eventually,
  expectValue,
  meanPngDifference,
  shootAside,
  slider,
  waitUntilReady,
} from './studio-page.ts'

const studio = openStudio({ width: 1000, height: 560 })
let page: Page

beforeAll(() => {
  ;({ page } = studio)
})

const card = () => page.getByRole('region', { name: 'Drop your avatar' })
const divider = () => page.getByRole('slider', { name: /^Divider/ })
const position = async () => Number(await divider().getAttribute('aria-valuenow'))
const hint = (text: string) => page.getByRole('status').getByText(text)
const pressed = () => page.locator('#expressions [aria-pressed=true]').textContent()

async function openEmpty(): Promise<void> {
  await page.goto(page.url().replace('?face=human', ''))
  await card().waitFor()
}

/** Drops an avatar, and waits until it has wrinkles. */
async function drop(file: string): Promise<void> {
  await dropOnPage(page, [join(studio.folder, file)])
  await areaChoice(page, 'foreheadInnerLeft').waitFor()
  await waitUntilReady(page)
}

test('the empty stage offers the shipped faces', async () => {
  await openEmpty()
  expect(await page.getByRole('tab').count()).toBe(0)
  expect(await divider().isVisible()).toBe(false)
  await button(page, 'Human 2').click()
  await waitUntilReady(page)
  await page.getByRole('button', { name: 'Project Human 2' }).waitFor()
  await card().waitFor({ state: 'detached' })
})

test('a dropped avatar performs while the divider crosses its face, and any input ends that', async () => {
  await openEmpty()
  await page.emulateMedia({ reducedMotion: 'no-preference' })
  await drop('plain.glb')
  await eventually(async () => expect(await position()).toBeLessThan(95))
  expect(await pressed()).not.toContain('Neutral')
  await page.keyboard.press('Shift')
  await eventually(async () => expect(await position()).toBe(50))
  await hint('Click a wrinkle').waitFor()
})

test('each hint disappears when the user has done what it says', async () => {
  await areaChoice(page, 'crowsFeetLeft').check()
  await hint('Drag across the line').waitFor()
  await slider(page, 'Depth, mm').press('ArrowRight')
  await hint('Press 1 to 9').waitFor()
  await page.keyboard.press('3')
  await hint('Press 1 to 9').waitFor({ state: 'detached' })
})

test('a reload continues with the work, its expression and its view', async () => {
  await page.getByText('Kept in this browser').waitFor()
  await page.getByRole('button', { name: 'Left', exact: true }).click()
  const depth = Number(await slider(page, 'Depth, mm').inputValue())
  await expectValue(slider(page, 'foreheadInnerLeft'), 0)
  const before = await shootAside(page)
  await page.reload()
  await waitUntilReady(page)
  await page.getByRole('button', { name: 'Project Plain' }).waitFor()
  await areaChoice(page, 'crowsFeetLeft').waitFor()
  await eventually(async () =>
    expect(await meanPngDifference(before, await shootAside(page))).toBeLessThan(0.5),
  )
  await areaChoice(page, 'crowsFeetLeft').check()
  await expectValue(slider(page, 'Depth, mm'), depth)
})

test('an avatar performs only once', async () => {
  await openEmpty()
  await page.getByRole('button', { name: /^plain/ }).waitFor()
  await drop('plain.glb')
  await page.getByText('Making wrinkles').waitFor({ state: 'detached' })
  expect(await position()).toBe(50)
  expect(await page.locator('.hint-card').count()).toBe(0)
})
