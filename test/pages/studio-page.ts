/** Functions that operate the studio's page, and read its state. */

import { join } from 'node:path'
import type { Locator, Page } from 'playwright-core'
import sharp from 'sharp'
import { expect, vi } from 'vitest'
import { dropPaths as dropOnPage } from '../../scripts/lib/drop-paths.mjs'

/** Time limit and polling interval, milliseconds. Pages compute and draw without a GPU. */
export const DRAWING = { timeout: 120_000, interval: 200 }

/** Waits until a face is shown. */
export async function waitUntilReady(page: Page, backend = ''): Promise<void> {
  await page.locator('#backend', { hasText: new RegExp(`^${backend}`) }).waitFor({ state: 'attached' })
  await page.locator('#stage[aria-busy=false]').waitFor()
}

/** JavaScript that unfolds all sections of the panel, and returns the HTML of controls that are cut off. */
export const CUT_CONTROLS = `(() => {
  for (const details of document.querySelectorAll('details')) details.open = true
  const isCut = (element) =>
    element.checkVisibility() &&
    !element.closest('.hidden, .title > :first-child') &&
    (element.scrollWidth > element.clientWidth + 1 || isOutside(element))
  const rightOf = (element) => element.getBoundingClientRect().right
  const isOutside = (element) => {
    const row = element.closest('.segments')
    return rightOf(element) > (row ? rightOf(row) : innerWidth) + 1
  }
  const found = document.querySelectorAll('button, .file span, .segments span, .label, legend, h2, #areas label')
  return [...found].filter(isCut).map(({ outerHTML }) => outerHTML)
})()`

export function slider(page: Page, name: string): Locator {
  return page.getByLabel(name, { exact: true })
}

export function button(page: Page, name: string): Locator {
  return page.getByRole('button', { name, exact: true })
}

/** Returns the radio button that selects an area in the list. */
export function areaChoice(page: Page, area: string): Locator {
  return page.getByRole('radio', { name: `Edit area ${area}`, exact: true })
}

/** Switches the pointer to drawing lines. Waits until the face shows the lines, because a worker prepares the skin first. */
export async function startDrawingLines(page: Page): Promise<void> {
  await page.getByRole('group', { name: 'Pointer' }).getByText('Draw', { exact: true }).click()
  await page.locator('canvas.lines').waitFor()
}

/** Returns the label of the step that undo would revert. */
export async function undoLabel(page: Page): Promise<string | undefined> {
  return (await button(page, 'Undo').getAttribute('title'))?.replace('Undo: ', '')
}

/** Waits until undo would revert the step with this label. */
export function undoIs(page: Page, label: string): Promise<void> {
  return eventually(async () => expect(await undoLabel(page)).toBe(label))
}

export function expectValue(input: Locator, value: number): Promise<void> {
  const check = async () => expect(Number(await input.inputValue())).toBeCloseTo(value, 2)
  return vi.waitFor(check, { timeout: 300_000, interval: 100 })
}

/** Takes pictures of the stage until two consecutive ones are equal, and returns the last. */
export async function shootStage(page: Page): Promise<Buffer> {
  const { width, height } = (await page.locator('#viewport').boundingBox())!
  // Leaves out the toolbar at the top and the changing numbers at the bottom.
  const clip = { x: 0, y: 60, width, height: height - 180 }
  const shoot = () => page.screenshot({ clip, style: '.messages, .divider, .sides { opacity: 0 }' })
  for (let before = await shoot(); ; ) {
    await page.evaluate(
      () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
    )
    const after = await shoot()
    if (before.equals(after)) return after
    before = after
  }
}

/** Takes a picture of the shipped face at rest without wrinkles, to compare with avatars made from this face. */
export async function shootPlainHuman(page: Page): Promise<Buffer> {
  await page.getByRole('button', { name: 'Neutral' }).click()
  await expectValue(slider(page, 'foreheadLeft'), 0)
  await page.getByRole('slider', { name: /^Divider/ }).press('End')
  return shootStage(page)
}

/** Takes a picture of the stage without the outlines of brush and focus, and without hover effects. */
export async function shootAside(page: Page): Promise<Buffer> {
  await page.mouse.move(page.viewportSize()!.width - 10, 5)
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur())
  return shootStage(page)
}

/**
 * Waits until the stage looks like the given picture.
 *
 * @param most largest mean difference, 0..255; by default the pictures must be equal.
 */
export function expectPicture(page: Page, picture: Buffer, most = 0): Promise<void> {
  const check = async () =>
    expect(await meanPngDifference(picture, await shootAside(page))).toBeLessThanOrEqual(most)
  return eventually(check)
}

/** Waits until a check passes, within the time limit of drawing. */
export function eventually<T>(check: () => T | Promise<T>): Promise<T> {
  return vi.waitFor(check, DRAWING)
}

/** Returns the mean difference of two pictures, 0..255. */
export async function meanPngDifference(a: Buffer, b: Buffer): Promise<number> {
  const [one, other] = await Promise.all([a, b].map((png) => sharp(png).removeAlpha().raw().toBuffer()))
  expect(other.length).toBe(one.length)
  return one.reduce((sum, value, i) => sum + Math.abs(value - other[i]), 0) / one.length
}

/** Returns the standard deviation of a picture's brightness: 0 if blank. */
export async function brightnessDeviation(png: Buffer): Promise<number> {
  const { channels } = await sharp(png).grayscale().stats()
  return channels[0].stdev
}

/** Waits for a message that contains a text, and dismisses it. */
export async function dismiss(page: Page, text: string): Promise<void> {
  await page.getByRole('alert').getByText(text).waitFor()
  await page.getByRole('button', { name: 'Dismiss' }).click()
}

/** Makes the image of an area that is visible everywhere: black, because black means visible. */
export function blackPng(): Promise<Buffer> {
  return sharp({ create: { width: 32, height: 32, channels: 3, background: '#000' } })
    .png()
    .toBuffer()
}

export async function drop(page: Page, name: string, content: Buffer): Promise<void> {
  const files = await page.evaluateHandle(
    ([fileName, base64]) => {
      const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0))
      const transfer = new DataTransfer()
      transfer.items.add(new File([bytes], fileName, { type: 'image/png' }))
      return transfer
    },
    [name, content.toString('base64')],
  )
  await page.dispatchEvent('#stage', 'dragover', { dataTransfer: files })
  expect(await page.locator('#dropping').isVisible()).toBe(true)
  await page.dispatchEvent('#stage', 'drop', { dataTransfer: files })
}

/** Presses the button of an expression, and collects the distinct values of a slider until nothing moves. */
export async function transitionValues(page: Page, expression: string, name: string): Promise<number[]> {
  const input = await slider(page, name).elementHandle()
  return page.getByRole('button', { name: expression }).evaluate(async (button, sliderInput) => {
    ;(button as HTMLElement).click()
    const values = new Set<number>()
    // At least 12 frames, because a slow machine draws few frames per second, and each frame advances the transition by at most 0.1 s.
    for (let frame = 0, start = performance.now(); frame < 12 || performance.now() - start < 1000; frame++) {
      values.add((sliderInput as HTMLInputElement).valueAsNumber)
      await new Promise(requestAnimationFrame)
    }
    return [...values]
  }, input)
}

/**
 * Drops files and folders from disk onto the page.
 *
 * @param name name of the face to wait for; by default the function does not wait.
 */
export async function dropPaths(page: Page, files: string[], name?: string): Promise<void> {
  await dropOnPage(page, files)
  if (name === undefined) return
  const shown = page.locator('#face option:checked', { hasText: new RegExp(`^${name}$`) })
  await shown.or(page.locator('#errors p')).first().waitFor({ state: 'attached' })
  expect(await page.textContent('#errors')).toBe('')
  await waitUntilReady(page)
}

/** Drops the avatar without wrinkles, and waits until it has an area. */
export async function dropPlain(page: Page, folder: string, area: string): Promise<void> {
  await dropPaths(page, [join(folder, 'plain.glb')], 'Plain')
  await areaChoice(page, area).waitFor()
}
