import { defineBrowserProvider } from '@vitest/browser'
import type { BrowserProvider, BrowserProviderOption } from 'vitest/node'
import type { BrowserKind, DrivenBrowser } from './driven-browser.ts'
import { launch } from './launch.ts'

/** Runs Vitest's tests in a browser that Playwright does not support. */
export function driven(kind: BrowserKind): BrowserProviderOption {
  return defineBrowserProvider({
    name: 'driven',
    providerFactory: () => new DrivenProvider(kind),
  })
}

class DrivenProvider implements BrowserProvider {
  readonly name = 'driven'
  readonly supportsParallelism = false
  private browser: Promise<DrivenBrowser> | undefined

  constructor(private readonly kind: BrowserKind) {}

  getCommandsContext(): Record<string, unknown> {
    return {}
  }

  async openPage(_session: string, url: string): Promise<void> {
    this.browser ??= launch(this.kind)
    await (await this.browser).open(url)
  }

  async close(): Promise<void> {
    await (await this.browser)?.close()
  }
}
