import type { Browser, Page } from 'playwright-core'
import { launchBrowser, newPage } from '../../packages/cli/src/browser.ts'

/** The browser that pages are tested in; the caller closes it. */
export const openBrowser = launchBrowser

/** An empty page, and what it will complain of: errors in its console, exceptions, requests that fail. */
export async function openPage(
  browser: Browser,
  options?: Parameters<Browser['newPage']>[0],
): Promise<{ page: Page; complaints: string[] }> {
  const page = await newPage(browser, options)
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
