/** Tests that all work except painting is possible by keyboard, and that the focus is always visible and never lost. */

import { join } from 'node:path'
import type { Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { openStudio } from './opened-studio.ts'
import { areaNames, waitUntilReady } from './studio-page.ts'

/** Number of key presses after which `tabTo` fails. The page has fewer controls. */
const MAX_KEYS = 500

const studio = openStudio({ width: 1280, height: 800 })
let page: Page
/** File that the tests choose in file dialogs. */
let file = 'plain.glb'
/** Names of the areas at the start. */
let names: string[]

beforeAll(async () => {
  ;({ page } = studio)
  // Registered before the first dialog, because Playwright takes a moment to intercept dialogs.
  page.on('filechooser', (chooser) => chooser.setFiles(join(studio.folder, file)))
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write'])
})

/** Returns label and value of the focused element, and whether its focus ring is visible. If nothing has the focus, `name` is `body`. */
async function focused(): Promise<{ name: string; value: string; isSeen: boolean }> {
  return page.evaluate(() => {
    const element = document.activeElement as HTMLInputElement
    if (element === document.body) return { name: 'body', value: '', isSeen: false }
    const text = element.ariaLabel ?? element.labels?.[0]?.textContent ?? element.textContent ?? ''
    // Elements that may draw the focus ring: the focused one, a pseudo-element, the next sibling, or a part.
    const drawn: [Element | null, string?][] = [
      [element],
      [element, '::after'],
      [element.nextElementSibling],
      [element.querySelector('.curve-grip')],
    ]
    const isSeen = drawn.some(([each, part]) => {
      if (!each) return false
      const { outlineStyle, outlineWidth, stroke } = getComputedStyle(each, part)
      return (
        (outlineStyle !== 'none' && outlineStyle !== 'auto' && parseFloat(outlineWidth) >= 2) ||
        (each.matches('.curve-grip') && stroke !== 'none')
      )
    })
    return {
      name: text.trim().replace(/\s+/g, ' '),
      value: element.ariaValueText ?? element.value ?? '',
      isSeen: isSeen && element.matches(':focus-visible'),
    }
  })
}

/** Presses Tab until the named control has the focus. Fails if the focus ring is invisible on any control on the way. */
async function tabTo(name: string | RegExp, key: 'Tab' | 'Shift+Tab' = 'Tab'): Promise<void> {
  const isIt = (text: string) => (typeof name === 'string' ? text === name : name.test(text))
  const passed: string[] = []
  for (let i = 0; i < MAX_KEYS; i++) {
    const { name: text, isSeen } = await focused()
    if (text !== 'body') expect(isSeen, `the focus on ${text}`).toBe(true)
    if (isIt(text)) return
    passed.push(text)
    await page.keyboard.press(key)
  }
  throw new Error(`No ${name} after ${MAX_KEYS} keys: ${[...new Set(passed)].join(', ')}`)
}

const backTo = (name: string | RegExp) => tabTo(name, 'Shift+Tab')

async function press(...keys: string[]): Promise<void> {
  for (const key of keys) await page.keyboard.press(key)
}

/** Unfolds a section of the page. The focus stays on its heading. */
async function unfold(name: string | RegExp, go = tabTo): Promise<void> {
  await go(name)
  const isOpen = () => page.evaluate(() => (document.activeElement!.parentElement as HTMLDetailsElement).open)
  if (!(await isOpen())) await press('Enter')
  expect(await isOpen()).toBe(true)
}

const value = async () => (await focused()).value
const areas = () => areaNames(page)
const waitForWrinkles = () => page.getByText('Making wrinkles').waitFor({ state: 'detached' })
const isUndoable = () => page.getByRole('button', { name: 'Undo' }).isEnabled()
const shown = () => page.evaluate(() => document.querySelector<HTMLElement>('.lines')?.hidden === false)

test('opens an avatar, and wrinkles are made for it', async () => {
  await tabTo(/^Project /)
  await press('Enter')
  // The card takes the focus in a later frame.
  await expect.poll(async () => (await focused()).name).toBe('Open…')
  await press('Enter')
  await page.getByRole('button', { name: 'Project Plain' }).waitFor()
  await waitUntilReady(page)
  await page.locator('#areas .row').first().waitFor()
  await waitForWrinkles()
  names = await areas()
  await expect.poll(async () => (await focused()).name).toMatch(/^Project /)
})

test('plays an expression', async () => {
  await press('2')
  await expect
    .poll(() => page.locator('#expressions button[aria-pressed=true]').textContent())
    .toBe('Surprised')
})

test('makes the wrinkles older', async () => {
  await tabTo('Age')
  await press('End')
  expect(await value()).toBe('80')
  await expect.poll(isUndoable).toBe(true)
  await waitForWrinkles()
})

test('picks a line, moves its points, and deletes a point and the line', async () => {
  await press('g')
  // A worker prepares the skin before lines can be drawn.
  await expect.poll(shown).toBe(true)
  await tabTo('Line')
  const lines = await page.getByLabel('Line', { exact: true }).locator('option').count()
  await press('o', 'u', 't', 'e', 'r')
  await tabTo(/^Point 1 of /)
  const count = async () => Number((await focused()).name.split(' ').at(-1))
  const before = await count()
  await tabTo(/^Point 2 of /)
  await press('ArrowUp', 'ArrowUp', 'Shift+ArrowLeft')
  await expect
    .poll(() => page.getByRole('button', { name: 'Undo' }).getAttribute('title'))
    .toBe('Undo: Move a point')
  await tabTo(`Point ${before} of ${before}`)
  await press('Delete')
  await expect.poll(async () => (await focused()).name).toBe(`Point ${before - 1} of ${before - 1}`)
  await tabTo('Edge distance, mm')
  const bank = Number((await value()).match(/[\d.]+/)![0])
  await press('ArrowRight')
  await expect.poll(value).toContain((bank + 0.1).toFixed(1))
  await tabTo('Steeper side')
  await press('ArrowLeft')
  await expect.poll(value).toContain('-0.05')
  await tabTo('Delete line')
  await press('Enter')
  await expect.poll(() => page.getByLabel('Line', { exact: true }).locator('option').count()).toBe(lines - 1)
  expect((await focused()).name).not.toBe('body')
  // The focus is on a list, in which letters choose a line.
  await backTo('Select')
  await press('Enter')
  await expect
    .poll(() => page.getByRole('button', { name: 'Bend' }).getAttribute('aria-pressed'))
    .toBe('false')
})

test('sets a blendshape', async () => {
  await tabTo('Sliders')
  await press('Enter')
  await unfold(/^Brows/)
  await tabTo('browInnerUp')
  await press('Home', 'ArrowRight', 'PageUp', 'End')
  expect(await value()).toBe('1')
})

test('picks an area, renames it, and changes how it overlaps', async () => {
  await backTo(/^Select .* [a-z]/)
  const name = (await focused()).name
  await press('ArrowDown', 'ArrowUp', 'Space')
  expect((await focused()).name).toBe(name)
  await unfold('Advanced')
  await tabTo('Name in the file')
  await press('Control+a')
  await page.keyboard.type('Browline')
  await press('Enter')
  await expect.poll(areas).toContain('Browline')
  expect(await focused()).toMatchObject({ name: 'Name in the file', value: 'Browline' })
  await tabTo('Overlap')
  await press('ArrowDown')
  expect(await value()).toBe('max')
})

test('records the pose, and edits the curve of its driver', async () => {
  await backTo('Look')
  await press('ArrowRight')
  await tabTo('Show it in this pose')
  await press('Enter')
  await expect
    .poll(() => page.getByRole('button', { name: 'Undo' }).getAttribute('title'))
    .toBe('Undo: Record the pose of Browline')
  await unfold('Advanced')
  await unfold(/^Blendshapes.*brow/)
  await tabTo('Point 1 of 2')
  await press('ArrowRight', 'ArrowRight', 'Shift+ArrowUp')
  await expect.poll(value).toMatch(/gives 0\.1$/)
  const drivers = () => page.locator('.driver').count()
  const before = await drivers()
  await tabTo('Remove this driver')
  await press('Enter')
  await expect.poll(drivers).toBe(before - 1)
  // The focus moves to the next driver, here the age, or to the control that adds a driver.
  expect((await focused()).name).toMatch(/^Age|Driver to add|Add driver/)
  await press('Control+z')
  await expect.poll(drivers).toBe(before)
})

test('changes a layer', async () => {
  await backTo('When')
  await press('ArrowRight')
  await expect.poll(async () => (await focused()).name).toBe('Maps')
  // The layer of the region is unfolded.
  await tabTo('Detail')
  await press('ArrowRight')
  expect((await focused()).name).toBe('Replace')
  await tabTo('Scale')
  await press('ArrowRight')
  expect(await value()).toBe('1.05')
  await backTo(/^Name of layer/)
  await press('Control+a')
  await page.keyboard.type('Skin')
  await press('Enter')
  expect(await focused()).toMatchObject({ name: 'Name of layer Skin', value: 'Skin' })
})

test('moves an area to another layer', async () => {
  await backTo('Maps')
  await press('ArrowRight')
  await expect.poll(async () => (await focused()).name).toBe('Look')
  await unfold('Advanced')
  await tabTo('Layer')
  const before = await value()
  await press('End')
  if ((await value()) === before) await press('Home')
  expect(await value()).not.toBe(before)
})

test('exports, and copies the code', async () => {
  await backTo('Export')
  const download = page.waitForEvent('download')
  await press('Enter')
  await download
  await tabTo('Exported file')
  await press('Enter')
  await tabTo('Copy the code')
  await press('Enter')
  await page.getByText('Copied the code').waitFor()
  expect(await page.evaluate(() => navigator.clipboard.readText())).toContain(
    "loadAsync('plain-wrinkled.glb')",
  )
})

test('turns the light, the camera and the divider', async () => {
  await press('Escape')
  await tabTo('Light')
  const light = await value()
  await press('ArrowLeft', 'ArrowUp')
  expect(await value()).not.toBe(light)
  await backTo(/^Divider/)
  await press('Home', 'PageUp')
  expect(await value()).toBe('10% without, 90% with wrinkles')
  const front = page.getByRole('button', { name: 'Front' })
  expect(await front.getAttribute('aria-pressed')).toBe('true')
  await backTo(/^The face/)
  await press('ArrowLeft', 'ArrowLeft', '+')
  await expect.poll(() => front.getAttribute('aria-pressed')).toBe('false')
})

test('reads the shortcuts and closes them', async () => {
  await press('?')
  await expect.poll(async () => (await focused()).name).toBe('Close')
  await press('Escape')
  await expect.poll(async () => (await focused()).name).toMatch(/^The face/)
})

test('undoes and redoes everything', async () => {
  const after = await areas()
  await backTo('Undo')
  for (let i = 0; (await isUndoable()) && i < MAX_KEYS; i++) await press('Enter')
  expect((await focused()).name).toBe('Undo')
  await expect.poll(areas).toEqual(names)
  const redo = page.getByRole('button', { name: 'Redo' })
  await tabTo('Redo')
  for (let i = 0; (await redo.isEnabled()) && i < MAX_KEYS; i++) await press('Enter')
  expect((await focused()).name).toBe('Redo')
  await expect.poll(areas).toEqual(after)
})

test('dismisses a message, and the focus is not lost', async () => {
  file = 'model.fbx'
  await backTo(/^Project /)
  await press('Enter')
  await tabTo('Open…')
  await press('Enter')
  await page.getByText('FBX file').waitFor()
  await press('Escape')
  await tabTo('Dismiss')
  await press('Enter')
  await expect.poll(() => page.textContent('#errors')).toBe('')
  expect((await focused()).name).not.toBe('body')
})
