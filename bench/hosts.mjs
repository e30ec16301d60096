// Hosts of the benchmark's page. `name` has the host's version and system. `open` returns the functions of a new page (`BenchPage` in
// page/page.ts), callable from this process.

import { emulateBrowser } from './dawn.mjs'
import { launchTimed, openPage } from './serve.mjs'

/** Starts a browser, with all renderers. */
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

/** Uses this process, with WebGPU only, without a browser or display. */
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
  measureUpdates: call('measureUpdates'),
})
