import { fileURLToPath } from 'node:url'
import { defineConfig } from 'vite'
import { SOURCES } from '../scripts/lib/sources.mjs'
import { guard } from './guard.ts'
import { offline } from './offline.ts'
import { serveExamples } from './serve-examples.ts'
import { serveFaces } from './serve-faces.ts'

const folder = (path: string) => fileURLToPath(new URL(path, import.meta.url))

/** What the page may need at any time; of the faces, the list and the one that it opens first. */
const isKept = (path: string) => !path.startsWith('faces/') || /^faces\/(index\.json|human\.glb)$/.test(path)

export default defineConfig({
  root: folder('.'),
  base: './',
  appType: 'mpa',
  publicDir: false,
  cacheDir: folder('../node_modules/.vite/studio'),
  plugins: [
    serveFaces(folder('../faces')),
    serveExamples(folder('../examples')),
    guard(folder('..')),
    offline(isKept),
  ],
  resolve: SOURCES.resolve,
  optimizeDeps: {
    // What is found late is optimised then, and reloads the page in the middle of work: what is not listed is served as it is.
    noDiscovery: true,
    include: [
      'three',
      'three/webgpu',
      'three/tsl',
      'three/addons/controls/OrbitControls.js',
      'three/addons/environments/RoomEnvironment.js',
      'three/addons/libs/meshopt_decoder.module.js',
      'three/addons/loaders/DRACOLoader.js',
      'three/addons/loaders/GLTFLoader.js',
      'three/addons/loaders/KTX2Loader.js',
      '@pixiv/three-vrm',
      // Of the examples.
      '@pixiv/three-vrm-core',
      'meshoptimizer/simplifier',
      'preact',
      'preact/hooks',
      'preact/jsx-runtime',
      'preact/jsx-dev-runtime',
      '@preact/signals',
      'three-mesh-bvh',
      'fflate',
      'idb',
      // Of the worker that packs faces.
      'comlink',
      '@gltf-transform/core',
      '@gltf-transform/extensions',
      'draco3d',
      'fast-png',
      'furrow-files > ktx-parse',
      'gltf-validator',
      'meshoptimizer/decoder',
    ],
    // They find their WebAssembly beside their own modules.
    exclude: ['ktx2-encoder', '@bokuweb/zstd-wasm'],
  },
  // Workers load parts of theirs when they are needed.
  worker: { format: 'es' },
  server: { fs: { allow: [folder('..')] } },
  // The page bundles three.js with both of its renderers.
  build: {
    outDir: folder('dist'),
    emptyOutDir: true,
    chunkSizeWarningLimit: 2500,
    // The first with `light-dark()`, whose substitute for older ones knows no dark stage on a light page.
    cssTarget: ['chrome123', 'firefox120', 'safari17.5'],
  },
})
