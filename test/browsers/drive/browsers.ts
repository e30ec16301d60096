import { chromium } from './chromium.ts'
import type { BrowserKind } from './driven-browser.ts'
import { firefox } from './firefox.ts'
import { webkit } from './webkit.ts'

/** Browsers to test. `npm run browsers` also tests Chromium, for comparison. */
const KINDS: readonly BrowserKind[] = [
  firefox,
  webkit,
  ...(process.env.FURROW_BROWSERS === 'all' ? [chromium] : []),
]

/** Browsers driven by WebDriver, with their names for `describe.each`. */
export const DRIVEN = KINDS.map((kind) => [kind.name, kind] as const)
