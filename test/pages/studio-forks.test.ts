/** Tests that forks of wrinkle lines are edited as one thing: by mouse, touch and keyboard, on the face and on its texture. */

import type { Locator, Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { writeNone } from './avatars.ts'
import { openStudio } from './opened-studio.ts'
import { button, chooseTool, eventually, startDrawingLines, undoIs } from './studio-page.ts'

type Point = readonly [x: number, y: number]

const studio = openStudio({ width: 1440, height: 800 }, writeNone)
let page: Page
/** Position of the fork on the page, CSS pixels. */
let fork: Point

const lines = () => page.getByLabel('Line', { exact: true })
/** Buttons of the forks on the chosen line. */
const forks = () => page.getByRole('button', { name: /^Point \d+ of \d+, a fork$/ })
const face = () => page.locator('canvas.lines')
const texture = () =>
  page
    .getByRole('application', { name: /^Texture/ })
    .locator('canvas')
    .first()

/** Chooses a line, counted from the end of the list: 1 is the last line. */
async function choose(fromEnd: number): Promise<void> {
  const count = await lines().locator('option').count()
  await lines().selectOption({ index: count - fromEnd })
}

async function drag(...path: Point[]): Promise<void> {
  await page.mouse.move(...path[0])
  await page.mouse.down()
  for (const to of path.slice(1)) await page.mouse.move(...to, { steps: 6 })
  await page.mouse.up()
}

/** Finds the centre of the chosen handle: a disc or diamond of one colour, larger than lines are wide. Fails if there is none. */
async function chosenHandle(canvas: Locator): Promise<Point> {
  const { x, y } = (await canvas.boundingBox())!
  const found = await eventually(async () => {
    const inside = await canvas.evaluate((element) => {
      const { width, height, clientWidth } = element as HTMLCanvasElement
      const { data } = (element as HTMLCanvasElement).getContext('2d')!.getImageData(0, 0, width, height)
      const isChosen = (px: number, py: number) =>
        [255, 157, 46].every((value, k) => Math.abs(data[4 * (py * width + px) + k] - value) <= 12)
      const hits: number[][] = []
      for (let py = 4; py + 4 < height; py++) {
        for (let px = 4; px + 4 < width; px++) {
          const around = [-4, 0, 4].flatMap((dy) => [-4, 0, 4].map((dx) => [dx, dy]))
          if (around.every(([dx, dy]) => Math.abs(dx) + Math.abs(dy) > 4 || isChosen(px + dx, py + dy)))
            hits.push([px, py])
        }
      }
      const mean = (k: number) => hits.reduce((sum, hit) => sum + hit[k], 0) / hits.length
      return hits.length > 0 ? [(mean(0) * clientWidth) / width, (mean(1) * clientWidth) / width] : null
    })
    expect(inside).not.toBeNull()
    return inside!
  })
  return [x + found[0], y + found[1]]
}

/** Expects that the chosen line has a fork, and that its handle is near a position. */
async function expectForkAt([x, y]: Point, canvas = face()): Promise<void> {
  await forks().click()
  await eventually(async () => {
    const [px, py] = await chosenHandle(canvas)
    expect(Math.hypot(px - x, py - y)).toBeLessThan(3)
  })
}

beforeAll(async () => {
  ;({ page } = studio)
  await button(page, 'Edit wrinkles').click()
  await startDrawingLines(page)
  const { x, y, width, height } = (await page.locator('#viewport').boundingBox())!
  const at = (u: number, v: number): Point => [x + u * width, y + v * height]
  // The skin above the forehead has no lines.
  await drag(at(0.44, 0.16), at(0.5, 0.15), at(0.56, 0.16))
  await undoIs(page, 'Draw a line')
  await chooseTool(page, 'Bend')
  const count = Number(
    (await page.getByRole('button', { name: /^Point 1 of/ }).getAttribute('aria-label'))!.at(-1),
  )
  await page.getByRole('button', { name: `Point ${Math.ceil(count / 2)} of ${count}` }).click()
  fork = await chosenHandle(face())
  await chooseTool(page, 'Draw a wrinkle')
  await drag([fork[0] + 20, fork[1] - 30], [fork[0] + 10, fork[1] - 15], fork)
  await drag([fork[0] - 15, fork[1] + 35], [fork[0] - 8, fork[1] + 18], fork)
  await chooseTool(page, 'Bend')
})

test('lines that end on another line form a fork with it', async () => {
  for (const line of [1, 2, 3]) {
    await choose(line)
    await expectForkAt(fork)
  }
})

test('a fork is dragged by mouse without choosing a line, and takes all its lines along', async () => {
  await lines().selectOption('')
  const target: Point = [fork[0] + 12, fork[1] + 16]
  await drag(fork, target)
  await undoIs(page, 'Move a fork')
  for (const line of [1, 2, 3]) {
    await choose(line)
    await expectForkAt(target)
  }
  await button(page, 'Undo').click()
  await undoIs(page, 'Draw a line')
  await expectForkAt(fork)
})

test('a fork is dragged by touch', async () => {
  await lines().selectOption('')
  const session = await page.context().newCDPSession(page)
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', offset = 0) =>
    session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: type === 'touchEnd' ? [] : [{ x: fork[0] + offset, y: fork[1] + offset }],
    })
  await touch('touchStart')
  for (const offset of [3, 6, 10]) await touch('touchMove', offset)
  await touch('touchEnd')
  await undoIs(page, 'Move a fork')
  await expectForkAt([fork[0] + 10, fork[1] + 10])
  await button(page, 'Undo').click()
})

test('a fork is moved by the keyboard, with one undo step per key press', async () => {
  await choose(2)
  await forks().focus()
  for (const _ of [1, 2, 3]) await page.keyboard.press('ArrowDown')
  await undoIs(page, 'Move a fork')
  await choose(1)
  await expectForkAt([fork[0], fork[1] + 6])
  for (const _ of [1, 2, 3]) await button(page, 'Undo').click()
  await undoIs(page, 'Draw a line')
})

test('a fork is dragged on the texture', async () => {
  await button(page, 'Texture').click()
  await choose(1)
  await forks().click()
  const from = await chosenHandle(texture())
  const target: Point = [from[0] + 5, from[1] + 8]
  await drag(from, target)
  await undoIs(page, 'Move a fork')
  for (const line of [1, 2, 3]) {
    await choose(line)
    await expectForkAt(target, texture())
  }
  await button(page, 'Undo').click()
  await button(page, 'Texture').click()
  await undoIs(page, 'Draw a line')
})

test('a bent trunk keeps its branches', async () => {
  await choose(3)
  const all = page.getByRole('button', { name: /^Point \d+ of \d+$/ })
  await all.first().click()
  const [x, y] = await chosenHandle(face())
  await drag([x, y], [x + 4, y + 20])
  await undoIs(page, 'Move a point')
  for (const line of [1, 2, 3]) {
    await choose(line)
    expect(await forks().count()).toBe(1)
  }
  await button(page, 'Undo').click()
})

test('a branch is detached, and deleted, without changing the others', async () => {
  await choose(1)
  await button(page, 'Detach from other line').click()
  await undoIs(page, 'Detach a line')
  expect(await forks().count()).toBe(0)
  expect(await button(page, 'Detach from other line').isDisabled()).toBe(true)
  await choose(2)
  await expectForkAt(fork)
  await button(page, 'Delete line').click()
  await undoIs(page, 'Remove a line')
  await choose(2)
  expect(await page.getByRole('button', { name: /^Point/ }).count()).toBeGreaterThan(1)
  expect(await forks().count()).toBe(0)
})
