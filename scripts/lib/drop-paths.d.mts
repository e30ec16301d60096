import type { Page } from 'playwright-core'

export declare function dropPaths(page: Page, files: readonly string[]): Promise<void>
