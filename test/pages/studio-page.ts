/** Functions that operate the studio's page, and read its state. */

import { join } from 'node:path'
import type { Download, Locator, Page } from 'playwright-core'
import sharp from 'sharp'
import { expect, vi } from 'vitest'
import { dropPaths as dropOnPage } from '../../scripts/lib/drop-paths.mjs'

/** Window sizes of the pictures in the guide. */
export const GUIDE_SIZES = [
  { width: 390, height: 844 },
  { width: 1280, height: 800 },
]

/** Time limit and polling interval, milliseconds. Pages compute and draw without a GPU. */
export const DRAWING = { timeout: 60_000, interval: 200 }

/** Waits until a face is shown. */
export async function waitUntilReady(page: Page, backend = ''): Promise<void> {
  await page.locator('#backend', { hasText: new RegExp(`^${backend}`) }).waitFor({ state: 'attached' })
  await page.locator('#stage[aria-busy=false]').waitFor()
}

/** JavaScript that unfolds all sections, and returns the HTML of controls that are cut off. */
export const CUT_CONTROLS = `(() => {
  for (const details of document.querySelectorAll('details')) details.open = true
  // The expressions scroll sideways.
  const isCut = (element) =>
    element.checkVisibility() &&
    !element.closest('.hidden, #expressions, .corner-row > .setting > .label') &&
    (element.scrollWidth > element.clientWidth + 1 || isOutside(element))
  const rightOf = (element) => element.getBoundingClientRect().right
  const isOutside = (element) => {
    const row = element.closest('.segments')
    return rightOf(element) > (row ? rightOf(row) : innerWidth) + 1
  }
  const found = document.querySelectorAll('button, .file span, .segments span, .label, legend, h2, #areas label')
  return [...found].filter(isCut).map(({ outerHTML }) => outerHTML)
})()`

/** Tools of the toolbar. */
export type ToolName =
  | 'Select'
  | 'Draw a wrinkle'
  | 'Bend'
  | 'Smooth'
  | 'Delete lines'
  | 'Paint'
  | 'Polygon'
  | 'Sculpt'
  | 'Mirror'

export function chooseTool(page: Page, name: ToolName): Promise<void> {
  const toolbar = page.getByRole('toolbar', { name: 'Tools' })
  return toolbar.getByRole('button', { name, exact: true }).click()
}

/** Shows a tab of the inspector. */
export function showTab(page: Page, name: 'Look' | 'When' | 'Maps'): Promise<void> {
  return page.getByRole('tab', { name, exact: true }).click()
}

/** Opens the sliders of the blendshapes, if they are closed. */
export async function showSliders(page: Page): Promise<void> {
  const toggle = button(page, 'Sliders')
  if ((await toggle.getAttribute('aria-expanded')) === 'false') await toggle.click()
}

/** Opens the card of the project, if it is closed, and returns it. */
export async function projectCard(page: Page): Promise<Locator> {
  const toggle = page.getByRole('button', { name: /^Project / })
  if ((await toggle.getAttribute('aria-expanded')) !== 'true') await toggle.click()
  const card = page.getByRole('dialog', { name: /^Project / })
  await card.waitFor()
  return card
}

/** Opens the last saved project. */
export async function openRecent(page: Page, name: RegExp): Promise<void> {
  const card = await projectCard(page)
  await card.getByRole('button', { name }).first().click()
}

export async function saveProject(page: Page): Promise<Download> {
  const card = await projectCard(page)
  const save = card.getByRole('button', { name: 'Save project (.zip)' })
  const [download] = await Promise.all([page.waitForEvent('download'), save.click()])
  await page.keyboard.press('Escape')
  return download
}

/** Presses Export, and returns the file that the page saves. */
export async function exportFile(page: Page): Promise<Download> {
  const [download] = await Promise.all([page.waitForEvent('download'), button(page, 'Export').click()])
  return download
}

/** Chooses an option in the preferences. */
export async function prefer(page: Page, group: string, option: string): Promise<void> {
  await button(page, 'Preferences').click()
  const dialog = page.getByRole('dialog', { name: 'Preferences' })
  await dialog.getByRole('group', { name: group }).getByText(option, { exact: true }).click()
  await button(page, 'Close').click()
}

/** Chooses what the stage shows. Rare looks are in a card, which then stays open. */
export async function chooseLook(page: Page, name: string): Promise<void> {
  const main = page.getByRole('group', { name: 'Show', exact: true })
  if (['Shaded', 'Relief', 'Strain'].includes(name)) return main.getByText(name).click()
  const toggle = button(page, 'More views')
  if ((await toggle.getAttribute('aria-expanded')) !== 'true') await toggle.click()
  return page.getByRole('group', { name: 'More views' }).getByText(name).click()
}

/** Returns the names in the file of all regions in the list. */
export async function areaNames(page: Page): Promise<string[]> {
  const labels = page.locator('#areas .row > label')
  return labels.evaluateAll((all) => all.map((label) => (label as HTMLElement).title))
}

/** Returns the slider with a label, or of a region with a name in the file. */
export function slider(page: Page, name: string): Locator {
  const escaped = name.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')
  const label = new RegExp(`(^|\\s)${escaped}\\s*$`)
  return page.locator('input[type=range]').and(page.getByLabel(label))
}

export function button(page: Page, name: string): Locator {
  return page.getByRole('button', { name, exact: true })
}

/** Returns the radio button that selects a region in the list, by its name in the file. */
export function areaChoice(page: Page, area: string): Locator {
  return page.getByRole('radio', { name: new RegExp(`^Select .* ${area}$`) })
}

/** Switches the pointer to drawing lines. Waits until the face shows the lines, because a worker prepares the skin first. */
export async function startDrawingLines(page: Page): Promise<void> {
  await chooseTool(page, 'Draw a wrinkle')
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

/** Controls and other overlays on the face. */
const OVERLAYS =
  '.toolbar, .corner, .making, .messages, .divider, .sides, .lines, .card, .explanation, .readout, .popover-place, .hints'

/** Takes pictures of the stage until two consecutive ones are equal, and returns the last. */
export async function shootStage(page: Page): Promise<Buffer> {
  const clip = (await page.locator('#viewport').boundingBox())!
  const shoot = () => page.screenshot({ clip, style: `${OVERLAYS} { opacity: 0 }` })
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
  await button(page, 'Neutral').click()
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

/** Accepts the guesses of the dialog that asks what dropped images are. */
export async function addImages(page: Page): Promise<void> {
  const dialog = page.getByRole('dialog', { name: /^What (is this image|are these images)/ })
  await dialog.getByRole('button', { name: 'Add', exact: true }).click()
  await dialog.waitFor({ state: 'detached' })
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
  const shown = page.getByRole('button', { name: `Project ${name}`, exact: true })
  await shown.or(page.locator('#errors p')).first().waitFor({ state: 'attached' })
  expect(await page.textContent('#errors')).toBe('')
  await waitUntilReady(page)
}

/** Drops the avatar without wrinkles, and waits until it has an area. */
export async function dropPlain(page: Page, folder: string, area: string): Promise<void> {
  await dropPaths(page, [join(folder, 'plain.glb')], 'Plain')
  await areaChoice(page, area).waitFor()
}

/**
 * Saves screenshots at several sizes of the window, if `FURROW_STUDIO_PICTURES` names a folder. The window keeps the last size.
 *
 * @param shown element to scroll the panel to.
 */
export async function savePictures(
  page: Page,
  name: string,
  sizes: readonly { width: number; height: number }[],
  shown?: Locator,
): Promise<void> {
  const folder = process.env.FURROW_STUDIO_PICTURES
  if (!folder) return
  for (const size of sizes) {
    await page.setViewportSize(size)
    await shown?.evaluate((element) => element.scrollIntoView({ block: 'center' }))
    await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 500)))
    await sharp(await page.screenshot())
      .webp({ quality: 85 })
      .toFile(join(folder, `${name}-${size.width}.webp`))
  }
}
