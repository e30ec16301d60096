/** Checks the main states of the studio with axe-core for violations of accessibility rules: light and dark, on desktop and phone. */

import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { join } from 'node:path'
import type { AxeResults } from 'axe-core'
import type { Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { openStudio } from './opened-studio.ts'
import {
  blackPng,
  chooseTool,
  drop,
  dropPaths,
  exportFile,
  projectCard,
  showTab,
  waitUntilReady,
} from './studio-page.ts'

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8')
const WINDOW = { width: 1280, height: 800 }
const PHONE = { width: 390, height: 844 }

const RULES = {
  runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'],
  // axe-core disables this rule by default.
  rules: { 'target-size': { enabled: true } },
  resultTypes: ['violations'],
}
/** Options that run only the rule that depends on the colour scheme. */
const OF_COLOURS = { runOnly: ['color-contrast'], resultTypes: ['violations'] }

const studio = openStudio(WINDOW)
let page: Page

beforeAll(async () => {
  ;({ page } = studio)
  await page.evaluate(AXE)
})

/** Lists violated rules, each with the elements that violate it. */
async function violations(rules: object): Promise<string[]> {
  const results = await page.evaluate(
    (options) => (globalThis as unknown as { axe: { run: Run } }).axe.run(document, options),
    rules,
  )
  return results.violations.flatMap(({ id, help, nodes }) =>
    nodes.map(({ html, any, all, none }) => {
      const reasons = [...any, ...all, ...none].map(({ message }) => message)
      return `${id} (${help}): ${html}\n  ${reasons.join('\n  ')}`
    }),
  )
}

type Run = (context: Document, options: object) => Promise<AxeResults>

/** Shows the inspector in the sheet of the phone. */
async function showSheet(): Promise<void> {
  const tab = page.getByRole('navigation', { name: 'Panels' }).getByRole('button', { name: 'Selection' })
  // A dialog hides the rest of the page.
  if ((await tab.count()) > 0 && (await tab.getAttribute('aria-expanded')) === 'false') await tab.click()
}

async function expectNone(): Promise<void> {
  const found: string[] = []
  for (const [where, viewport] of Object.entries({ window: WINDOW, phone: PHONE })) {
    await page.setViewportSize(viewport)
    if (viewport === PHONE) await showSheet()
    for (const [colorScheme, rules] of [['dark', RULES] as const, ['light', OF_COLOURS] as const]) {
      await page.emulateMedia({ colorScheme })
      const own = await violations(rules)
      found.push(...own.map((violation) => `${colorScheme}, ${where}: ${violation}`))
    }
  }
  await page.setViewportSize(WINDOW)
  expect(found).toEqual([])
}

const button = (name: string) => page.getByRole('button', { name, exact: true })

function unfoldAll(): Promise<void> {
  return page.evaluate(() => {
    for (const details of document.querySelectorAll('details')) details.open = true
  })
}

test('no violation on opening', expectNone)

test('no violation with an avatar whose wrinkles are made', async () => {
  await dropPaths(page, [join(studio.folder, 'turned.vrm')], 'Turned')
  await page.locator('#areas .row').first().waitFor()
  await page.getByText('Making wrinkles').waitFor({ state: 'detached' })
  await showTab(page, 'When')
  await unfoldAll()
  // The studio recognises blendshapes once the section is unfolded.
  await page.locator('.shape').first().waitFor()
  await expectNone()
})

test('no violation with every type of driver unfolded', async () => {
  await page
    .getByRole('radio', { name: /^Select / })
    .first()
    .check()
  await showTab(page, 'When')
  await unfoldAll()
  const list = page.getByLabel('Driver to add')
  for (const label of await list.locator('option').allTextContents()) {
    await list.selectOption({ label })
    await button('Add driver').click()
  }
  await expect.poll(() => page.locator('.driver').count()).toBeGreaterThan(9)
  await unfoldAll()
  await page
    .getByRole('button', { name: /^Curve of / })
    .first()
    .click()
  await button('Add a conflict').click()
  await expectNone()
})

test('no violation while painting, by brush and by polygon', async () => {
  await chooseTool(page, 'Paint')
  await expectNone()
  await chooseTool(page, 'Polygon')
  await expectNone()
  await chooseTool(page, 'Select')
})

test('no violation with the texture next to the face', async () => {
  await button('Texture').click()
  await page.locator('#texture canvas').waitFor()
  await expectNone()
  await button('Texture').click()
})

test('no violation while editing lines', async () => {
  await showTab(page, 'Look')
  await chooseTool(page, 'Bend')
  await page.getByLabel('Line', { exact: true }).selectOption({ index: 1 })
  await expectNone()
  await chooseTool(page, 'Draw a wrinkle')
  await expectNone()
})

test('no violation with an exported file', async () => {
  await exportFile(page)
  await button('Exported file').click()
  await button('Copy the code').waitFor()
  await expectNone()
  await page.keyboard.press('Escape')
})

test('no violation with a message and an expression that plays', async () => {
  await dropPaths(page, [join(studio.folder, 'model.fbx')])
  await page.getByRole('alert').filter({ hasText: 'fbx' }).waitFor()
  await button('Surprised').click()
  await expectNone()
  await page.getByRole('button', { name: 'Dismiss' }).click()
})

test('no violation in the question about a dropped image', async () => {
  await drop(page, 'skin_normal.png', await blackPng())
  await page.getByRole('dialog', { name: 'What is this image?' }).waitFor()
  await expectNone()
  await button('Close').last().click()
})

test('no violation with the list of shortcuts', async () => {
  await button('Shortcuts').click()
  await expectNone()
  await button('Close').last().click()
})

test('no violation in the preferences, and in the other views', async () => {
  await button('Preferences').click()
  await expectNone()
  await button('Close').click()
  await button('More views').click()
  await expectNone()
  await page.keyboard.press('Escape')
})

test('no violation in each mode, and in the tab of the maps', async () => {
  for (const mode of ['Lines', 'Paint', 'Motion', 'Look']) {
    await page.getByRole('group', { name: 'Mode' }).getByText(mode, { exact: true }).click()
    await expectNone()
  }
  await showTab(page, 'Maps')
  await expectNone()
})

test('no violation with the list of recent projects', async () => {
  await page.reload()
  await waitUntilReady(page)
  await page.evaluate(AXE)
  await projectCard(page)
  await expectNone()
})
