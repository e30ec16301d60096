// Two hosts that run the benchmark's page: Chromium, and Node without a browser. A host's `name` includes its version and the operating system.
// Its `open` opens a page and returns functions that call the page's functions (`BenchPage` in page/page.ts) from this process.

import { emulateBrowser } from './dawn.mjs'
import { launchTimed, openPage } from './serve.mjs'

export async function chromiumHost(server) {
  const browser = await launchTimed(server)
  return {
    name: `Chromium ${browser.version()}, ${process.platform}`,
    async open() {
      const page = await openPage(server, browser, '/bench/page/page.html', 'bench')
      const call =
        (name) =>
        (...args) =>
          page.evaluate(([name, args]) => globalThis.bench[name](...args), [name, args])
      return { ...pageFunctions(call), close: () => page.close() }
    },
    close: () => browser.close(),
  }
}

/** Runs the page in this Node process, without a browser or display. Supports only WebGPU. */
export async function nodeHost(server) {
  await emulateBrowser()
  await server.ssrLoadModule('/bench/page/page.ts')
  return {
    name: `Dawn in Node ${process.versions.node}, ${process.platform}`,
    async open() {
      const call =
        (name) =>
        (...args) =>
          globalThis.bench[name](...args)
      return { ...pageFunctions(call), async close() {} }
    },
    async close() {},
  }
}

const pageFunctions = (call) => ({
  open: call('open'),
  measure: call('measure'),
  measureCrowd: call('measureCrowd'),
  measureWalkers: call('measureWalkers'),
  measureUpdates: call('measureUpdates'),
})
