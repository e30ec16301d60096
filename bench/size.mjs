// What a page downloads of the library, minified, then gzipped or as Brotli; three.js and the user's own code apart. A page's own size is
// that of all it loads before a file: what files need is fetched when they do, and measured apart.

import { brotliCompressSync, gzipSync } from 'node:zlib'
import { build } from 'vite'
import { ROOT } from './serve.mjs'

/** What pages have besides. */
export const ELSEWHERE = /^(three|react|react-dom|@react-three\/fiber|@babylonjs\/(?:core|loaders))(\/|$)/

/** What each page imports. */
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

/** Fetched by pages with the loader alone: the modules that are imported on demand. */
const FETCHED = {
  'the modes composed and paper': ['three/webgl/modes/other-modes', 'three/webgpu/modes/other-modes'],
  'other maps than normals': ['three/webgl/mixing/channels', 'three/webgpu/mixing/channels'],
  'KTX 2': ['three/loader/ktx2', 'babylon/loader/ktx2'],
  'the option fadeBelow': ['three/camera/size-on-screen'],
  relief: [
    'three/relief/relief',
    'three/webgl/relief/relief',
    'three/webgpu/relief/relief',
    'three/relief/relief-control',
  ],
  'the option auto': ['three/loader/auto-wrinkles', 'auto/start-worker'],
}

/**
 * Bytes by gzip and Brotli: of each page, and of what is fetched later by pages with the loader alone.
 *
 * @returns {Promise<Record<string, { gzip: number, brotli: number }>>}
 */
export async function measureSizes() {
  const sizes = {}
  for (const [page, code] of Object.entries(PAGES)) {
    const chunks = await bundle(`${code}; globalThis.used = used`, ELSEWHERE)
    const [entry] = chunks
    const own = closure([entry], chunks)
    sizes[page] = compressed(own)
    if (!page.startsWith('the loader')) continue
    for (const [what, modules] of Object.entries(FETCHED)) {
      const roots = chunks.filter(({ facadeModuleId: id }) =>
        modules.some((name) => id?.endsWith(`/furrow/dist/${name}.js`)),
      )
      const later = closure(roots, chunks).filter((chunk) => !own.includes(chunk))
      if (later.length > 0) sizes[`${page}: ${what}`] = compressed(later)
    }
  }
  return sizes
}

/** Other libraries that add to a character or a scene, for comparison. */
const PEERS = {
  '@pixiv/three-vrm': ['VRMLoaderPlugin'],
  '@react-three/drei': ['Text', 'Facemesh', 'Stage', 'useGLTF', 'Environment', 'OrbitControls'],
}

/** The same of what pages import of other libraries, without three.js and React. */
export async function measurePeers() {
  const sizes = {}
  for (const [library, names] of Object.entries(PEERS)) {
    for (const name of names) {
      const code = `import { ${name} as used } from '${library}'; globalThis.used = used`
      const chunks = await bundle(code, ELSEWHERE)
      sizes[`${name}, ${library}`] = compressed(closure([chunks[0]], chunks))
    }
  }
  return sizes
}

/** The least that shows the shipped face, see `bench/download/floor.ts`. */
const FLOOR = {
  'the floor, normals only':
    "import { floorPlugin } from '/bench/download/floor.ts'; const used = floorPlugin()",
  'the floor, all maps of the shipped face':
    "import { floorPlugin } from '/bench/download/floor.ts'; import { surfaceChannels } from '/bench/download/surface.ts'; const used = floorPlugin(surfaceChannels)",
}

/** The same of the floor. */
export async function measureFloor() {
  const sizes = {}
  for (const [what, code] of Object.entries(FLOOR)) {
    sizes[what] = compressed(await bundle(`${code}; globalThis.used = used`, ELSEWHERE))
  }
  return sizes
}

const PAGE = 'virtual:page'

/** Builds a page as a bundler would; its first chunk comes first. */
export async function bundle(code, external) {
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
      // Not as a library: of those Vite leaves the spaces.
      rolldownOptions: { input: PAGE, external },
    },
  })
  // Vite sets it, and what is run after this would be built for production too.
  if (NODE_ENV === undefined) delete process.env.NODE_ENV
  return output.filter(({ type }) => type === 'chunk').sort((a, b) => Number(b.isEntry) - Number(a.isEntry))
}

/** Some chunks, and all that they import at once. */
export function closure(chunks, all) {
  const found = new Set(chunks)
  for (const { imports } of found) {
    for (const name of imports) {
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
