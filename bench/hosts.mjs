// Where the benchmark's page runs. A host offers `open`, which gives the page's functions (`BenchPage` in page.ts) for one renderer,
// each to be called from here.

import { becomeBrowser } from './dawn.mjs'
import { openPage } from './serve.mjs'

/** In a browser: every renderer. */
export async function chromiumHost(server) {
  const { launchBrowser } = await server.ssrLoadModule('/packages/cli/src/browser.ts')
  const browser = await launchBrowser()
  return {
    async open() {
      const page = await openPage(server, browser, '/bench/index.html', 'bench')
      const call =
        (name) =>
        (...args) =>
          page.evaluate(([name, args]) => globalThis.bench[name](...args), [name, args])
      return { ...functions(call), close: () => page.close() }
    },
    close: () => browser.close(),
  }
}

/** In this process: WebGPU alone, but without a browser or a display. */
export async function nodeHost(server) {
  await becomeBrowser()
  await server.ssrLoadModule('/bench/page.ts')
  return {
    async open() {
      const call =
        (name) =>
        (...args) =>
          globalThis.bench[name](...args)
      return { ...functions(call), async close() {} }
    },
    async close() {},
  }
}

const functions = (call) => ({
  open: call('open'),
  measure: call('measure'),
  measureCrowd: call('measureCrowd'),
})
