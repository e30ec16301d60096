import type { Browser, Page } from 'playwright-core'
import { launchBrowser } from '../../packages/cli/src/browser.ts'

/** A page whose complaints are kept, so that a test can demand that there are none. */
export interface Watched {
  page: Page
  /** Errors and warnings that the page wrote to its console, and exceptions nobody caught. */
  complaints: string[]
}

/** Starts the installed browser without a window; the test closes it. */
export function openBrowser(): Promise<Browser> {
  return launchBrowser()
}

export async function openPage(browser: Browser, width = 800, height = 600): Promise<Watched> {
  const page = await browser.newPage({ viewport: { width, height } })
  const complaints: string[] = []
  page.on('console', (message) => {
    const text = message.text()
    if (['error', 'warning'].includes(message.type()) && !isDriverTalk(text)) complaints.push(text)
  })
  page.on('pageerror', (error) => complaints.push(String(error)))
  page.on('requestfailed', (request) => complaints.push(`not loaded: ${request.url()}`))
  return { page, complaints }
}

/** The graphics driver's own remarks on speed, and Chromium's on software rendering: not the page's doing. */
function isDriverTalk(text: string): boolean {
  return /GL Driver Message|software WebGL|powerPreference|fallback adapter/i.test(text)
}
