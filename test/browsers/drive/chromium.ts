import { launchBrowser } from '../../../packages/cli/src/browser.ts'
import type { BrowserKind } from './driven-browser.ts'

interface Action {
  type: string
  x: number
  y: number
}

/** Chromium through Playwright, with the interface of the other browsers. */
export const chromium: BrowserKind = {
  name: 'chromium',
  async launch() {
    const browser = await launchBrowser()
    const page = await browser.newPage()
    return {
      version: browser.version(),
      open: async (url) => void (await page.goto(url)),
      evaluate: (body) => page.evaluate(`(async () => { ${body} })()`),
      async act(sources) {
        for (const { type, x, y } of (sources as { actions: Action[] }[]).flatMap(({ actions }) => actions)) {
          if (type === 'pointerMove') await page.mouse.move(x, y, { steps: 4 })
          else if (type === 'pointerDown') await page.mouse.down()
          else await page.mouse.up()
        }
      },
      screenshot: () => page.screenshot(),
      resize: (width, height) => page.setViewportSize({ width, height }),
      close: () => browser.close(),
    }
  },
}
