// Measures how many bytes of the library a page downloads. Files are minified and compressed, and three.js and other peer dependencies are excluded.

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

/** Lazy chunks by name. The regular expression of a chunk matches the path of its entry module. */
const LAZY = { relief: /relief-web/, 'automatic wrinkles': /auto-wrinkles/, 'KTX 2': /ktx2/ }

/**
 * Measures the compressed bytes of each page in `PAGES`, and those of the lazy chunks of pages that import only a loader.
 *
 * @returns {Promise<Record<string, { gzip: number, brotli: number }>>}
 */
export async function measureSizes() {
  const sizes = {}
  for (const [page, code] of Object.entries(PAGES)) {
    const chunks = await bundle(`${code}; globalThis.used = used`)
    const eager = closure([chunks[0]], chunks)
    sizes[page] = compressed(eager)
    if (!page.startsWith('the loader')) continue
    for (const [name, file] of Object.entries(LAZY)) {
      const roots = chunks.filter(({ facadeModuleId: id }) => file.test(id ?? ''))
      const rest = chunks.filter((chunk) => !eager.includes(chunk))
      const lazy = closure(roots, rest, ['imports', 'dynamicImports'])
      if (lazy.length > 0) sizes[`${page}: ${name}`] = compressed(lazy)
    }
  }
  return sizes
}

const PAGE = 'virtual:page'

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
      // With `ssr`, Vite does not add its helper for dynamic imports.
      ssr: true,
      // This is not Vite's library mode, because library mode keeps whitespace.
      rolldownOptions: { input: PAGE, external: PEERS },
    },
  })
  // Vite sets NODE_ENV, which would affect later builds.
  if (NODE_ENV === undefined) delete process.env.NODE_ENV
  return output.filter(({ type }) => type === 'chunk').sort((a, b) => Number(b.isEntry) - Number(a.isEntry))
}

/** Returns `chunks` and all chunks that they import, directly or indirectly. `kinds` selects static imports, dynamic imports, or both. */
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

/** Sums the compressed sizes of chunks, in bytes. Each chunk is compressed separately, as servers do. */
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
