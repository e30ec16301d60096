/** Tests how an artist edits the drivers of an area: recording a pose, editing curves, adding conflicting blendshapes. */

import type { Locator, Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { writeNone } from './avatars.ts'
import { openStudio } from './opened-studio.ts'
import { areaChoice, expectValue, showSliders, showTab, slider } from './studio-page.ts'

const studio = openStudio({ width: 1200, height: 800 }, writeNone)
let page: Page

beforeAll(async () => {
  ;({ page } = studio)
  await page.getByRole('button', { name: 'Edit wrinkles' }).click()
  await areaChoice(page, 'lowerLip').check()
  await showTab(page, 'When')
  await page.locator('.drivers > summary').click()
  await showSliders(page)
  for (const group of ['Brows', 'Jaw', 'Mouth']) {
    await page.locator('#targets summary', { hasText: group }).click()
  }
})

const lip = () => slider(page, 'lowerLip')
const neutral = () => page.getByRole('button', { name: 'Neutral', exact: true }).click()
const undo = () => page.getByRole('button', { name: 'Undo' }).click()
const redo = () => page.getByRole('button', { name: 'Redo' }).click()
const cards = () => page.locator('.driver')
const lastCard = () => cards().last()
/** Returns a point of the curve of the last driver. */
const point = (name: string) => lastCard().getByRole('slider', { name })
const activationShown = async () => Number(await lip().inputValue())

async function pose(weights: Readonly<Record<string, number>>): Promise<void> {
  await neutral()
  for (const [name, weight] of Object.entries(weights)) await slider(page, name).fill(String(weight))
}

async function addDriver(type: string): Promise<void> {
  const before = await cards().count()
  await page.getByLabel('Driver to add').selectOption({ label: type })
  await page.getByRole('button', { name: 'Add driver' }).click()
  await expect.poll(() => cards().count(), { timeout: 60_000 }).toBe(before + 1)
}

async function dragBy(handle: Locator, x: number, y: number): Promise<void> {
  await handle.scrollIntoViewIfNeeded()
  const box = (await handle.boundingBox())!
  const [startX, startY] = [box.x + box.width / 2, box.y + box.height / 2]
  await page.mouse.move(startX, startY)
  await page.mouse.down()
  for (let i = 1; i <= 4; i++) await page.mouse.move(startX + (x * i) / 4, startY + (y * i) / 4)
  await page.mouse.up()
}

test('a recorded pose shows the area, and undo removes the recording', async () => {
  const raised = { browInnerUp: 0.6, jawOpen: 0.3 }
  await pose(raised)
  const before = await activationShown()
  expect(before).toBeLessThan(0.9)
  await page.getByRole('button', { name: 'Show it in this pose' }).click()
  await expectValue(lip(), 1)
  await neutral()
  await expectValue(lip(), 0)
  await pose(raised)
  await expectValue(lip(), 1)
  await slider(page, 'jawOpen').fill('0')
  await expect.poll(activationShown, { timeout: 60_000 }).toBeLessThan(0.95)
  await slider(page, 'jawOpen').fill('0.3')
  await undo()
  await expectValue(lip(), before)
  await redo()
  await expectValue(lip(), 1)
})

test('a point of the curve follows the mouse in one undo step', async () => {
  await lastCard().locator('summary').click()
  const last = point('Point 2 of 2')
  const width = (await lastCard().locator('svg.curve-plot').boundingBox())!.width
  await dragBy(last, -width / 2, 0)
  await expect.poll(() => last.getAttribute('aria-valuetext')).toMatch(/^Together 0\.4\d? gives 1$/)
  await pose({ browInnerUp: 0.6 })
  await expectValue(lip(), 1)
  await undo()
  await expect.poll(() => last.getAttribute('aria-valuetext')).toBe('Together 1 gives 1')
  await expect.poll(activationShown, { timeout: 60_000 }).toBeLessThan(0.95)
})

test('a finger drags a point in one undo step', async () => {
  const last = point('Point 2 of 2')
  const text = () => last.getAttribute('aria-valuetext')
  await last.scrollIntoViewIfNeeded()
  const before = await text()
  const { x, y, width, height } = (await last.boundingBox())!
  const session = await page.context().newCDPSession(page)
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', down = 0) => {
    const touchPoints = [{ x: x + width / 2, y: y + height / 2 + down }]
    return session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: type === 'touchEnd' ? [] : touchPoints,
    })
  }
  await touch('touchStart')
  for (const down of [5, 15, 30]) await touch('touchMove', down)
  await touch('touchEnd')
  await session.detach()
  await expect.poll(text).toMatch(/gives 0\.[5-9]/)
  await undo()
  await expect.poll(text).toBe(before)
})

test('arrow keys move a point, Delete removes one, and buttons add points', async () => {
  const first = point('Point 1 of 2')
  await first.focus()
  for (const key of ['ArrowRight', 'ArrowRight', 'Shift+ArrowUp']) await first.press(key)
  expect(await first.getAttribute('aria-valuetext')).toBe('Together 0.02 gives 0.1')
  await lastCard().getByRole('button', { name: 'Add a point' }).click()
  await point('Point 3 of 3').waitFor()
  await point('Point 2 of 3').press('Delete')
  await point('Point 2 of 2').waitFor()
  expect(await first.getAttribute('aria-valuetext')).toBe('Together 0.02 gives 0.1')
})

test('a marker shows the input on the curve, and numbers show what a driver contributes', async () => {
  const marker = lastCard().locator('.curve-now line')
  const at = () => marker.evaluate((line) => line.getBoundingClientRect().x)
  await pose({})
  const left = await at()
  await pose({ browInnerUp: 0.6, jawOpen: 0.3 })
  await expect.poll(at).toBeGreaterThan(left + 100)
  await lastCard().getByText('Now: 1 gives 1.00').waitFor()
  expect(await lastCard().locator('summary output').textContent()).toBe('1.00')
})

test('the reasons shown for the area under the mouse follow the face', async () => {
  await page.locator('#areas label', { hasText: 'lowerLip' }).hover()
  const shown = () => page.getByRole('meter', { name: 'Lower lip' }).getAttribute('value')
  await expect.poll(shown).toBe('1')
  for (const name of ['browInnerUp', 'jawOpen']) {
    // Sets the value without focus, because focus would scroll the area away from the mouse.
    await slider(page, name).evaluate((input: HTMLInputElement) => {
      input.value = '0'
      input.dispatchEvent(new Event('input', { bubbles: true }))
    })
  }
  await expect.poll(shown).toBe('0.1')
})

test('a tab tells when a region shows: its expressions, whose pictures play them, and its strongest drivers', async () => {
  const shown = page.getByRole('group', { name: 'Expressions that show it' })
  const first = shown.getByRole('button').first()
  await first.click()
  await expect.poll(activationShown, { timeout: 60_000 }).toBeGreaterThan(0.2)
  expect(await first.getAttribute('aria-pressed')).toBe('true')
  const strongest = page.getByRole('region', { name: 'Strongest drivers' })
  const bars = await strongest
    .getByRole('meter')
    .evaluateAll((all) => all.map((each) => (each as HTMLMeterElement).value))
  expect(bars).toEqual(bars.toSorted((a, b) => b - a))
  expect(bars.length).toBeLessThanOrEqual(3)
  await strongest.locator('summary', { hasText: 'browInnerUp' }).click()
  await strongest.getByRole('group', { name: 'Curve of browInnerUp alone' }).waitFor()
  await strongest.locator('summary', { hasText: 'browInnerUp' }).click()
})

test('conflicting blendshapes cancel each other until the conflict is removed', async () => {
  await pose({ browInnerUp: 0.6, jawOpen: 0.3, browDownLeft: 0.6 })
  await expectValue(lip(), 1)
  await page.locator('.conflicts summary').click()
  await page.getByRole('button', { name: 'Add a conflict' }).click()
  await page.getByLabel('One side').selectOption('browInnerUp')
  await page.getByLabel('Other side').selectOption('browDownLeft')
  await page.getByText('0.60 is taken from both now').waitFor()
  await expect.poll(activationShown, { timeout: 60_000 }).toBeLessThan(0.5)
  await page.getByRole('button', { name: 'Remove the conflict of browInnerUp and browDownLeft' }).click()
  await expectValue(lip(), 1)
})

test('an age drives the area, and an invalid driver shows its problem with a remedy', async () => {
  await neutral()
  await addDriver('Age')
  await lastCard().getByLabel('Age now').fill('80')
  await expectValue(lip(), 1)
  await lastCard().getByLabel('Age now').fill('20')
  await addDriver('Delay')
  await addDriver('Delay')
  const earlier = cards().nth(-2)
  await earlier.locator('summary').click()
  await earlier.getByRole('button', { name: 'Remove it' }).click()
  await expect.poll(() => page.getByText('A later delay of this area counts').count()).toBe(0)
})

test('every available type of driver can be added and undone', async () => {
  const types = await page.getByLabel('Driver to add').locator('option:not([disabled])').allTextContents()
  expect(types).toEqual(
    expect.arrayContaining(['Blendshapes', 'Other areas', 'Skin tension', 'Number', 'Muscle', 'Expression']),
  )
  const count = await cards().count()
  for (const type of types) {
    await addDriver(type)
    await undo()
    await expect.poll(() => cards().count(), { timeout: 60_000 }).toBe(count)
  }
})
