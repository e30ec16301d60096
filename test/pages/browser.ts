import type { Browser, Page } from 'playwright-core'
import { launchBrowser, newPage } from '../../packages/cli/src/browser.ts'

/** Milliseconds that an element or a page is waited for: a missing one fails its test long before the test's own limit. */
const PATIENCE = 120_000

/** Opens the browser for tests of pages; the caller closes it. */
export const openBrowser = launchBrowser

/** Opens an empty page, and collects its console errors, exceptions and failed requests. */
export async function openPage(
  browser: Browser,
  options?: Parameters<Browser['newPage']>[0],
): Promise<{ page: Page; complaints: string[] }> {
  const page = await newPage(browser, options)
  page.setDefaultTimeout(PATIENCE)
  const complaints: string[] = []
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text())
  })
  page.on('pageerror', (error) => complaints.push(error.stack ?? error.message))
  page.on('response', (response) => {
    if (response.status() >= 400) complaints.push(`${response.status()} ${response.url()}`)
  })
  return { page, complaints }
}
