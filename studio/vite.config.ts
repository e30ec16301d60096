import { fileURLToPath } from 'node:url'
import { defineConfig } from 'vite'
import { SOURCES } from '../scripts/lib/sources.mjs'
import { guard } from './guard.ts'
import { offline } from './offline.ts'
import { serveExamples } from './serve-examples.ts'
import { serveFaces } from './serve-faces.ts'

const folder = (path: string) => fileURLToPath(new URL(path, import.meta.url))

/** Whether the service worker caches a file in advance. Excludes all faces except one, and includes the portraits of all. */
const isKept = (path: string) =>
  !path.startsWith('faces/') || /^faces\/(index\.json|human\.glb|portraits\/.*)$/.test(path)

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
    // If Vite discovers a dependency late, it reloads the page, and the user loses work. So bundle only the dependencies in this list.
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
      'preact/compat',
      '@zag-js/preact',
      '@zag-js/dialog',
      '@zag-js/popover',
      '@zag-js/tabs',
      '@zag-js/tooltip',
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
    // These packages load WebAssembly from the folder of their modules. Bundling would move the modules.
    exclude: ['ktx2-encoder', '@bokuweb/zstd-wasm'],
  },
  // Workers use dynamic imports, which need this format.
  worker: { format: 'es' },
  server: { fs: { allow: [folder('..')] } },
  build: {
    outDir: folder('dist'),
    emptyOutDir: true,
    // Kilobytes. The page contains three.js with both renderers.
    chunkSizeWarningLimit: 2500,
    // First browsers that support `light-dark()`. Vite's replacement for older browsers would not allow a dark stage on a light page.
    cssTarget: ['chrome123', 'firefox120', 'safari17.5'],
  },
})
