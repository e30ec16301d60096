/** Tests the tasks of an artist's first hour, and counts the inputs that each takes: clicks, drags and keys. */

import { copyFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Locator, Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { dropPaths as dropOnPage } from '../../scripts/lib/drop-paths.mjs'
import { openStudio } from './opened-studio.ts'
import {
  areaChoice,
  button,
  eventually,
  expectValue,
  meanPngDifference,
  savePictures,
  shootAside,
  slider,
  undoIs,
  waitUntilReady,
} from './studio-page.ts'

const WINDOW = { width: 1120, height: 700 }
const PICTURES = [
  { width: 390, height: 844 },
  { width: 1440, height: 900 },
]

const studio = openStudio(WINDOW)
let page: Page
/** Inputs of the current task. */
let inputs = 0

beforeAll(() => {
  ;({ page } = studio)
})

async function click(target: Locator): Promise<void> {
  inputs++
  await target.click()
}

async function press(key: string): Promise<void> {
  inputs++
  await page.keyboard.press(key)
}

interface Place {
  x: number
  y: number
}

async function drag(from: Place, to: Place): Promise<void> {
  inputs++
  await page.mouse.move(from.x, from.y)
  await page.mouse.down()
  await page.mouse.move(to.x, to.y, { steps: 8 })
  await page.mouse.up()
}

async function drop(file: string): Promise<void> {
  inputs++
  await dropOnPage(page, [join(studio.folder, file)])
}

/** Ends a task. @param expected number of inputs that the task takes. */
async function finish(name: string, expected: number): Promise<void> {
  expect(inputs, name).toBe(expected)
  inputs = 0
  await savePictures(page, `journey-${name}`, PICTURES)
  await page.setViewportSize(WINDOW)
}

const wrinkles = () => page.getByText('Making wrinkles').waitFor({ state: 'detached' })

/** Returns a place on the stage. @param x @param y fractions of its width and height. */
async function placeAt(x: number, y: number): Promise<Place> {
  const box = (await page.locator('#viewport').boundingBox())!
  return { x: box.x + x * box.width, y: box.y + y * box.height }
}

/** Whether a line lights up, in the frame after next. */
const isLit = () =>
  page.locator('canvas.lines').evaluate(async (canvas: HTMLCanvasElement) => {
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)))
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height)
    return data.some((value) => value > 0)
  })

/** Moves the pointer down the right half of the forehead until a line lights up, and returns the place. */
async function findLine(): Promise<Place> {
  return eventually(async () => {
    for (let y = 0.14; y < 0.3; y += 0.006) {
      const place = await placeAt(0.56, y)
      await page.mouse.move(place.x, place.y)
      if (await isLit()) return place
    }
    throw new Error('no line lights up on the forehead')
  })
}

test('drop an avatar, and see its wrinkles', async () => {
  await page.goto(page.url().replace('?face=human', ''))
  await page.emulateMedia({ reducedMotion: 'no-preference' })
  await drop('plain.glb')
  await areaChoice(page, 'foreheadInnerLeft').waitFor()
  await wrinkles()
  const shown = page.locator('#expressions [aria-pressed=true]')
  await eventually(async () => expect(await shown.textContent()).not.toContain('Neutral'))
  await page.getByText('Click a wrinkle').waitFor({ timeout: 300_000 })
  await page.emulateMedia({ reducedMotion: 'reduce' })
  await finish('reveal', 1)
})

test('deepen a wrinkle and its counterpart', async () => {
  await button(page, 'Surprised').click()
  inputs = 0
  const line = await findLine()
  await press('m')
  await drag(line, { x: line.x, y: line.y + 30 })
  await undoIs(page, 'Change the depth of a line')
  await expect.poll(() => slider(page, 'Depth, mm').inputValue().then(Number)).toBeGreaterThan(0.3)
  await press('m')
  await finish('deepen', 3)
})

test('the overlay follows the pointer in the next frame', async () => {
  await button(page, 'Whole face').click()
  const line = await findLine()
  const away = await placeAt(0.95, 0.95)
  await page.mouse.move(away.x, away.y)
  await expect.poll(isLit).toBe(false)
  const isLitAtOnce = await page.evaluate(async ({ x, y }) => {
    const moved = { bubbles: true, clientX: x, clientY: y, pointerType: 'mouse', isPrimary: true }
    document.elementFromPoint(x, y)!.dispatchEvent(new PointerEvent('pointermove', moved))
    await new Promise(requestAnimationFrame)
    const canvas = document.querySelector<HTMLCanvasElement>('canvas.lines')!
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height)
    return data.some((value) => value > 0)
  }, line)
  expect(isLitAtOnce).toBe(true)
})

test('draw a line that always shows', async () => {
  const scalp = [await placeAt(0.47, 0.1), await placeAt(0.53, 0.1)] as const
  await press('d')
  await page.locator('canvas.lines').waitFor()
  await eventually(async () => {
    inputs = 1
    await drag(...scalp)
    expect(await page.getByText('When does this wrinkle show?').count()).toBe(1)
  })
  await click(button(page, 'Always'))
  await expectValue(slider(page, 'lines'), 1)
  await press('v')
  await finish('draw', 4)
})

test('paint a wrinkle', async () => {
  const cheek = [await placeAt(0.675, 0.53), await placeAt(0.69, 0.57)] as const
  await press('b')
  await eventually(async () => {
    inputs = 1
    await drag(...cheek)
    expect(await page.getByText('When does this wrinkle show?').count()).toBe(1)
  })
  const before = await shootAside(page)
  await click(button(page, 'Fill with lines'))
  await undoIs(page, 'Fill Painted with lines')
  await click(button(page, 'Always'))
  await eventually(async () => {
    expect(await meanPngDifference(before, await shootAside(page))).toBeGreaterThan(0.02)
  })
  await finish('paint', 4)
  await press('v')
  await button(page, 'Whole face').click()
  inputs = 0
})

test('sculpt a bag under each eye', async () => {
  const bag = [await placeAt(0.57, 0.5), await placeAt(0.62, 0.505)] as const
  const before = await shootAside(page)
  await press('c')
  await press('m')
  await drag(...bag)
  await undoIs(page, 'Sculpt')
  await click(button(page, 'Always'))
  await eventually(async () => {
    expect(await meanPngDifference(before, await shootAside(page))).toBeGreaterThan(0.1)
  })
  await finish('sculpt', 4)
  await press('m')
  await press('v')
  inputs = 0
})

test('hide a mesh', async () => {
  const before = await shootAside(page)
  await click(button(page, 'Show brows'))
  await eventually(async () => {
    expect(await meanPngDifference(before, await shootAside(page))).toBeGreaterThan(0.05)
  })
  await finish('hide', 1)
})

test('apply a preset to a second avatar', async () => {
  await slider(page, 'Age').press('End')
  await wrinkles()
  inputs = 0
  const download = page.waitForEvent('download')
  await click(button(page, 'Save preset'))
  await (await download).saveAs(join(studio.folder, 'preset.json'))
  copyFileSync(join(studio.folder, 'plain.glb'), join(studio.folder, 'second.glb'))
  await drop('second.glb')
  await page.getByRole('button', { name: 'Project Second' }).waitFor()
  await waitUntilReady(page)
  await areaChoice(page, 'foreheadInnerLeft').waitFor()
  await wrinkles()
  await expectValue(slider(page, 'Age'), 45)
  await drop('preset.json')
  await expectValue(slider(page, 'Age'), 80)
  await wrinkles()
  await finish('preset', 3)
})

test('export the file', async () => {
  const download = page.waitForEvent('download')
  await click(button(page, 'Export'))
  expect((await download).suggestedFilename()).toBe('second-wrinkled.glb')
  await finish('export', 1)
})
