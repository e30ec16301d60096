// Download size of the library, minified and gzipped, without three.js and the page's own code.

import { gzipSync } from 'node:zlib'
import { build } from 'vite'
import { ROOT } from './serve.mjs'

/** What each page imports. */
const PAGES = {
  'the loader, furrow/three': "export { WrinkleLoaderPlugin } from 'furrow/three'",
  'the loader, furrow/webgpu': "export { WrinkleLoaderPlugin } from 'furrow/webgpu'",
  'all of furrow/three': "export * from 'furrow/three'",
  'all of furrow/webgpu': "export * from 'furrow/webgpu'",
}

const PAGE = 'virtual:page'

/** Gzipped bytes of each page. */
export async function measureSizes() {
  const sizes = []
  for (const [page, code] of Object.entries(PAGES)) {
    const { output } = await build({
      root: ROOT,
      configFile: false,
      logLevel: 'silent',
      plugins: [virtualPage(code)],
      build: {
        write: false,
        minify: true,
        // Not in library mode, where Vite keeps whitespace.
        rolldownOptions: { input: PAGE, external: /^three(\/|$)/, preserveEntrySignatures: 'strict' },
      },
    })
    sizes.push({ page, gzipped: gzipSync(output[0].code, { level: 9 }).length })
  }
  return sizes
}

function virtualPage(code) {
  return {
    name: 'virtual-page',
    resolveId: (id) => (id === PAGE ? `${ROOT}bench/${PAGE}.js` : undefined),
    load: (id) => (id.endsWith(`${PAGE}.js`) ? code : undefined),
  }
}
