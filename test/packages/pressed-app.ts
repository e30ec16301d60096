import { expect } from 'vitest'
import { openPage } from '../pages/browser.ts'
import type { ServedApp } from './served-app.ts'
import { settled } from './settled.ts'

/**
 * Opens an app that shows a face. Expects that a click changes the picture, and that the page reports no errors.
 *
 * @returns URLs of requests to other origins.
 */
export async function expectFaceThatChanges(app: ServedApp, query: string): Promise<string[]> {
  const { page, complaints } = await openPage(app.browser, { viewport: { width: 300, height: 300 } })
  const foreign: string[] = []
  page.on('request', (request) => {
    if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(app.origin))
      foreign.push(request.url())
  })
  // Delays the file of the face until a picture of the empty page is taken.
  let showFace = () => {}
  const mayShow = new Promise<void>((resolve) => {
    showFace = resolve
  })
  await page.route('**/*.glb', (route) => mayShow.then(() => route.continue()))
  await page.goto(`${app.origin}/?${query}`)
  const canvas = page.locator('canvas')
  await canvas.waitFor()
  const empty = await page.screenshot()
  showFace()
  const shown = await settled(page, empty)
  await canvas.click()
  await settled(page, shown)
  expect(complaints).toEqual([])
  await page.close()
  return foreign
}
