import { chromium } from './chromium.ts'
import type { BrowserKind } from './driven-browser.ts'
import { firefox } from './firefox.ts'
import { webkit } from './webkit.ts'

/** `npm run browsers` compares the others with Chromium, in which all other tests run. */
const KINDS: readonly BrowserKind[] = [
  firefox,
  webkit,
  ...(process.env.FURROW_BROWSERS === 'all' ? [chromium] : []),
]

/** Browsers that tests drive by WebDriver, by their names. */
export const DRIVEN = KINDS.map((kind) => [kind.name, kind] as const)
