// The download of a page: minified, each file compressed by itself, without three.js and other peers.

import { brotliCompressSync, gzipSync } from 'node:zlib'
import { build } from 'vite'
import { ROOT } from './serve.mjs'

const PEERS = /^(three|react|react-dom|@react-three\/fiber|@babylonjs\/(?:core|loaders))(\/|$)/

const PAGES = {
  'the loader, furrow/three': "import { WrinkleLoaderPlugin as used } from 'furrow/three'",
  'the loader, furrow/webgpu': "import { WrinkleLoaderPlugin as used } from 'furrow/webgpu'",
  'extendLoader and useWrinkles, furrow/react':
    "import { extendLoader, useWrinkles } from 'furrow/react'; const used = [extendLoader, useWrinkles]",
  'the loader, furrow/babylon': "import { registerWrinkleMaps as used } from 'furrow/babylon'",
  'all of furrow/three': "import * as used from 'furrow/three'",
  'all of furrow/webgpu': "import * as used from 'furrow/webgpu'",
  'all of furrow/react': "import * as used from 'furrow/react'",
  'all of furrow/babylon': "import * as used from 'furrow/babylon'",
}

/** The lazy chunks, by the names of the package's files. */
const LAZY = { relief: /relief-web/, 'automatic wrinkles': /auto-wrinkles/, 'KTX 2': /ktx2/ }

/**
 * Bytes by gzip and Brotli: of each page, and of the lazy chunks of pages with a loader.
 *
 * @returns {Promise<Record<string, { gzip: number, brotli: number }>>}
 */
export async function measureSizes() {
  const sizes = {}
  for (const [page, code] of Object.entries(PAGES)) {
    const chunks = await bundle(`${code}; globalThis.used = used`)
    const own = closure([chunks[0]], chunks)
    sizes[page] = compressed(own)
    if (!page.startsWith('the loader')) continue
    for (const [what, file] of Object.entries(LAZY)) {
      const roots = chunks.filter(({ facadeModuleId: id }) => file.test(id ?? ''))
      const others = chunks.filter((chunk) => !own.includes(chunk))
      const later = closure(roots, others, ['imports', 'dynamicImports'])
      if (later.length > 0) sizes[`${page}: ${what}`] = compressed(later)
    }
  }
  return sizes
}

const PAGE = 'virtual:page'

/** Builds a page as a bundler would. The page's own chunk comes first. */
async function bundle(code) {
  const { NODE_ENV } = process.env
  const { output } = await build({
    root: ROOT,
    configFile: false,
    logLevel: 'silent',
    plugins: [virtualPage(code)],
    ssr: { noExternal: true },
    build: {
      write: false,
      minify: true,
      // Without Vite's own helper for dynamic imports.
      ssr: true,
      // Not as a library: Vite leaves the spaces in those.
      rolldownOptions: { input: PAGE, external: PEERS },
    },
  })
  // Vite sets it, and whatever runs after this would be built for production too.
  if (NODE_ENV === undefined) delete process.env.NODE_ENV
  return output.filter(({ type }) => type === 'chunk').sort((a, b) => Number(b.isEntry) - Number(a.isEntry))
}

/** Some chunks, and all that they import at once; with `dynamicImports` among the kinds, later too. */
export function closure(chunks, all, kinds = ['imports']) {
  const found = new Set(chunks)
  for (const each of found) {
    for (const name of kinds.flatMap((kind) => each[kind])) {
      const chunk = all.find(({ fileName }) => fileName === name)
      if (chunk) found.add(chunk)
    }
  }
  return [...found]
}

/** Each file is compressed by itself, as servers do. */
export function compressed(chunks) {
  const sum = (compress) => chunks.reduce((total, { code }) => total + compress(code).length, 0)
  return {
    gzip: sum((code) => gzipSync(code, { level: 9 })),
    brotli: sum((code) => brotliCompressSync(code)),
  }
}

function virtualPage(code) {
  return {
    name: 'virtual-page',
    resolveId: (id) => (id === PAGE ? `${ROOT}bench/${PAGE}.js` : undefined),
    load: (id) => (id.endsWith(`${PAGE}.js`) ? code : undefined),
  }
}
