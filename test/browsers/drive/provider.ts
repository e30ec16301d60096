import { defineBrowserProvider } from '@vitest/browser'
import type { BrowserProvider, BrowserProviderOption } from 'vitest/node'
import type { DrivenBrowser } from './driven-browser.ts'
import { type BrowserName, launch } from './launch.ts'

/** Runs Vitest's tests in a browser that Playwright cannot drive. */
export function driven(name: BrowserName): BrowserProviderOption {
  return defineBrowserProvider({
    name: 'driven',
    providerFactory: () => new DrivenProvider(name),
  })
}

class DrivenProvider implements BrowserProvider {
  readonly name = 'driven'
  readonly supportsParallelism = false
  private browser: Promise<DrivenBrowser> | undefined

  constructor(private readonly browserName: BrowserName) {}

  getCommandsContext(): Record<string, unknown> {
    return {}
  }

  async openPage(_session: string, url: string): Promise<void> {
    this.browser ??= launch(this.browserName)
    await (await this.browser).open(url)
  }

  async close(): Promise<void> {
    await (await this.browser)?.close()
  }
}
