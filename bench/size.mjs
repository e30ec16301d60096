// What a page downloads of the library, minified and gzipped; three.js, the user's own code and what is fetched on demand apart:
// KTX 2, key frames of areas and muscles come when a file has them.

import { gzipSync } from 'node:zlib'
import { build } from 'vite'
import { ROOT } from './serve.mjs'

/** What each page imports. */
const PAGES = {
  'the loader, furrow/three': "import { WrinkleLoaderPlugin as used } from 'furrow/three'",
  'the loader, furrow/webgpu': "import { WrinkleLoaderPlugin as used } from 'furrow/webgpu'",
  'all of furrow/three': "import * as used from 'furrow/three'",
  'all of furrow/webgpu': "import * as used from 'furrow/webgpu'",
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
      plugins: [virtualPage(`${code}; globalThis.used = used`)],
      ssr: { noExternal: true },
      build: {
        write: false,
        minify: true,
        // Without Vite's own helper for dynamic imports.
        ssr: true,
        // Not as a library: of those Vite leaves the spaces.
        rolldownOptions: { input: PAGE, external: /^three(\/|$)/ },
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
