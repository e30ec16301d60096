import { chromium } from './chromium.ts'
import type { BrowserKind } from './driven-browser.ts'
import { firefox } from './firefox.ts'
import { webkit } from './webkit.ts'

/** Includes Chromium, which all other tests run in, as the baseline of `npm run browsers`. */
const KINDS: readonly BrowserKind[] = [
  firefox,
  webkit,
  ...(process.env.FURROW_BROWSERS === 'all' ? [chromium] : []),
]

/** Browsers driven by WebDriver, with their names for `describe.each`. */
export const DRIVEN = KINDS.map((kind) => [kind.name, kind] as const)
