import { fileURLToPath } from 'node:url'
import { defineConfig } from 'vite'
import { SOURCES } from '../scripts/lib/sources.mjs'
import { guard } from './guard.ts'
import { offline } from './offline.ts'
import { serveExamples } from './serve-examples.ts'
import { serveFaces } from './serve-faces.ts'

const folder = (path: string) => fileURLToPath(new URL(path, import.meta.url))

/** Whether a file is cached in advance: everything except most faces. */
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
    // A dependency found late would reload the page during work, so all are listed. Others are served unbundled.
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
      // For the examples.
      '@pixiv/three-vrm-core',
      'react',
      'react-dom/client',
      '@react-three/fiber',
      'meshoptimizer/simplifier',
      'preact',
      'preact/hooks',
      'preact/jsx-runtime',
      'preact/jsx-dev-runtime',
      '@preact/signals',
      'three-mesh-bvh',
      'fflate',
      'idb',
      // For the worker that packs faces.
      'comlink',
      '@gltf-transform/core',
      '@gltf-transform/extensions',
      'draco3d',
      'fast-png',
      'furrow-files > ktx-parse',
      'gltf-validator',
      'meshoptimizer/decoder',
    ],
    // These packages load WebAssembly relative to their modules.
    exclude: ['ktx2-encoder', '@bokuweb/zstd-wasm'],
  },
  // Workers use dynamic imports.
  worker: { format: 'es' },
  server: { fs: { allow: [folder('..')] } },
  // The page bundles three.js with both renderers.
  build: {
    outDir: folder('dist'),
    emptyOutDir: true,
    chunkSizeWarningLimit: 2500,
    // First versions with `light-dark()`. Its polyfill does not support a dark stage on a light page.
    cssTarget: ['chrome123', 'firefox120', 'safari17.5'],
  },
})
