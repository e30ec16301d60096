/** Tests that the page follows the system's or the user's choice of light or dark, and shows all content at every width. */

import type { Page } from 'playwright-core'
import sharp from 'sharp'
import { beforeAll, describe, expect, test } from 'vitest'
import { writeNone } from './avatars.ts'
import { openStudio } from './opened-studio.ts'
import { button, CUT_CONTROLS, prefer, waitUntilReady } from './studio-page.ts'

const WINDOW = { width: 1280, height: 800 }

const studio = openStudio(WINDOW, writeNone)
let page: Page

beforeAll(() => {
  ;({ page } = studio)
})

const choose = (name: string) => prefer(page, 'Theme', name)

/** Returns the mean brightness of an element and everything drawn over it, 0..255. */
async function brightness(selector: string): Promise<number> {
  const picture = sharp(await page.locator(selector).screenshot()).grayscale()
  return (await picture.stats()).channels[0].mean
}

const isLight = async () => (await brightness('#inspector')) > 180

describe('light and dark', () => {
  test('follow the system, and the stage stays dark', async () => {
    for (const colorScheme of ['dark', 'light'] as const) {
      await page.emulateMedia({ colorScheme })
      expect(await isLight()).toBe(colorScheme === 'light')
      expect(await brightness('#views')).toBeLessThan(120)
      const field = await page.locator('#face').evaluate((select) => getComputedStyle(select).colorScheme)
      expect(field).toBe('light dark')
    }
  })

  test('are fixed by a choice, also on the next visit, until the system is chosen again', async () => {
    await page.emulateMedia({ colorScheme: 'light' })
    await choose('Dark')
    expect(await isLight()).toBe(false)
    await page.reload()
    await waitUntilReady(page)
    expect(await isLight()).toBe(false)
    await page.emulateMedia({ colorScheme: 'dark' })
    await choose('Light')
    expect(await isLight()).toBe(true)
    await choose('System')
    expect(await isLight()).toBe(false)
  })

  test('keep selections visible in forced colours mode', async () => {
    await page.emulateMedia({ forcedColors: 'active' })
    await button(page, 'Happy').click()
    const colours = await page.evaluate(() =>
      ['true', 'false'].map((pressed) => {
        const button = document.querySelector(`#expressions [aria-pressed=${pressed}]`)!
        return getComputedStyle(button).backgroundColor
      }),
    )
    expect(colours[0]).not.toBe(colours[1])
    await page.emulateMedia({ forcedColors: 'none' })
  })
})

test('on a high-density screen the texture fills its view', async () => {
  const session = await page.context().newCDPSession(page)
  await session.send('Emulation.setDeviceMetricsOverride', { ...WINDOW, deviceScaleFactor: 2, mobile: false })
  const toggle = page.getByRole('button', { name: 'Texture' })
  await toggle.click()
  const canvas = page.locator('#texture canvas')
  const [view, picture] = [await page.locator('#texture').boundingBox(), await canvas.boundingBox()]
  // The width of the border is the allowed difference.
  expect(picture!.width).toBeCloseTo(view!.width, -1)
  expect(picture!.height).toBeCloseTo(view!.height, -1)
  await toggle.click()
  await session.send('Emulation.clearDeviceMetricsOverride')
  await session.detach()
})

test.each([390, 640, 768, 1280, 1920, 2560])('all content is in view at %i pixels', async (width) => {
  await page.setViewportSize({ width, height: 800 })
  const tabs = page.getByRole('navigation', { name: 'Panels' }).getByRole('button')
  const isSmall = await tabs.first().isVisible()
  for (const [i, id] of ['inspector', 'drawer', 'poses'].entries()) {
    const tab = tabs.nth([1, 0, 2][i])
    if (isSmall && (await tab.getAttribute('aria-expanded')) === 'false') await tab.click()
    const edit = page.getByRole('button', { name: 'Edit wrinkles' })
    if (await edit.isVisible()) {
      await edit.click()
      await page.getByRole('tab', { name: 'Look' }).waitFor()
    }
    if (id === 'drawer') await page.getByRole('radio', { name: / upperLip$/ }).check()
    expect(await page.evaluate(CUT_CONTROLS), id).toEqual([])
    const overflow = await page.locator(`#${id}`).evaluate((panel) => panel.scrollWidth - panel.clientWidth)
    expect(overflow, id).toBe(0)
  }
})
