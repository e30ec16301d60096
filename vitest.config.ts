import { readdirSync, readFileSync } from 'node:fs'
import { playwright } from '@vitest/browser-playwright'
import { defineConfig, type TestProjectInlineConfiguration } from 'vitest/config'
import { CHROMIUM_FLAGS } from './packages/cli/src/chromium-flags.ts'
import { serveGodot } from './scripts/lib/godot.mjs'
import { mtoonNodes } from './scripts/lib/mtoon-nodes.mjs'
import { SOURCES } from './scripts/lib/sources.mjs'
import { PROMISES } from './scripts/lib/test-files.mjs'
import type { BrowserKind } from './test/browsers/drive/driven-browser.ts'
import { firefox } from './test/browsers/drive/firefox.ts'
import { driven } from './test/browsers/drive/provider.ts'
import { webkit } from './test/browsers/drive/webkit.ts'
import { FILES_FOR_OLDEST_BABYLON, onOldestBabylon } from './test/gpu/babylon/oldest-babylon.ts'
import { FILES_FOR_OLDEST, onOldestThree } from './test/gpu/oldest-three.ts'
import { serveFaces } from './test/gpu/serve-faces.ts'

const { resolve, ssr } = SOURCES

// Milliseconds. These limits only end hanging tests, so they are long enough for slow or busy machines.
const SOON = { testTimeout: 300_000, hookTimeout: 300_000 }
const LATE = { testTimeout: 900_000, hookTimeout: 900_000 }

// By default Vitest leaves one core idle, which is half of a machine with two cores.
const ALL_CORES = { maxWorkers: '100%' }
// Threads start twice as fast as processes, which shortens the unit tests by a seventh.
const IN_THREADS = { pool: 'threads' } as const

declare module 'vitest' {
  export interface ProvidedContext {
    /** Whether tests use all rendering paths and all random cases, which takes several times as long. */
    inDepth: boolean
    /** Whether the browser may lack WebGPU. */
    mayLackWebGPU: boolean
  }
}

/** True in `npm run test:all`, which sets the environment variable. */
const inDepth = process.env.FURROW_TESTS === 'all'
const provide = { inDepth, mayLackWebGPU: false }
const HEAVY = inDepth ? [] : ['test/unit/**/*.heavy.test.ts']

const PROMISES_ON_GPU = PROMISES.filter((file) => file.startsWith('test/gpu/'))

// `scripts/lib/test-files.mjs` lists which of these files `npm test` runs.
export default defineConfig({
  test: {
    projects: [
      {
        resolve,
        ssr,
        test: {
          name: 'unit',
          include: ['test/unit/**/*.test.ts'],
          exclude: HEAVY,
          provide,
          ...SOON,
          ...ALL_CORES,
          ...IN_THREADS,
        },
      },
      packagesProject('packages'),
      pagesProject('pages'),
      gpuProject('gpu', ['test/gpu/**/*.test.ts']),
      gpuProject('godot', ['test/godot/**/*.test.ts']),
      onOldestThree(gpuProject('gpu-oldest', FILES_FOR_OLDEST)),
      onOldestBabylon(gpuProject('gpu-oldest-babylon', FILES_FOR_OLDEST_BABYLON)),
      onBrowser(firefox, gpuProject('firefox', PROMISES_ON_GPU)),
      onBrowser(webkit, gpuProject('webkit', PROMISES_ON_GPU)),
      pagesProject('browsers'),
      pagesProject('batch'),
      pagesProject('site'),
    ],
  },
})

/** Project for applications that install the published packages. They run in parallel, because they mostly wait for npm. */
function packagesProject(name: string): TestProjectInlineConfiguration {
  const globalSetup = 'test/packages/tarballs.ts'
  return {
    resolve,
    ssr,
    test: { name, include: [`test/${name}/**/*.test.ts`], globalSetup, ...LATE, ...ALL_CORES },
  }
}

/** Project for complete pages and commands, which run one at a time. */
function pagesProject(name: string): TestProjectInlineConfiguration {
  // Vitest's default of one second is too short for pages on a busy machine.
  const poll = { timeout: 120_000 }
  return {
    resolve,
    ssr,
    test: { name, include: [`test/${name}/**/*.test.ts`], ...LATE, expect: { poll }, fileParallelism: false },
  }
}

/** Lists the paths of all Babylon.js modules that the sources and tests import. */
function babylonModules(): string[] {
  const folders = ['packages/furrow/src/babylon', 'test/gpu/babylon', 'test/gpu/conformance']
  const texts = folders.flatMap((folder) =>
    readdirSync(folder, { recursive: true, encoding: 'utf8' })
      .filter((path) => path.endsWith('.ts'))
      .map((path) => readFileSync(`${folder}/${path}`, 'utf8')),
  )
  // Type-only imports vanish at run time.
  const imports = texts.flatMap((text) => [
    ...text.matchAll(/^(?:import|} from) (?!type)(?:.* from )?'(@babylonjs[^']+)'/gm),
  ])
  return [...new Set(imports.map(([, name]) => name))]
}

/** Project for tests in Chromium, which use the rendering paths of `test/gpu/harness.ts`. */
function gpuProject(name: string, include: string[]): TestProjectInlineConfiguration {
  return {
    resolve,
    ssr,
    plugins: [serveFaces(SOURCES), serveGodot(), mtoonNodes()],
    optimizeDeps: {
      // If Vite discovered a dependency during a test, it would reload the page. Dependencies that are not listed are served unchanged.
      noDiscovery: true,
      include: [
        'three',
        'three/webgpu',
        'three/tsl',
        'three/addons/libs/meshopt_decoder.module.js',
        'three/addons/loaders/GLTFLoader.js',
        'three/addons/loaders/KTX2Loader.js',
        'three/addons/loaders/DRACOLoader.js',
        'three/addons/utils/SkeletonUtils.js',
        '@pixiv/three-vrm',
        '@pixiv/three-vrm-core',
        '@pixiv/three-vrm-materials-mtoon',
        'idb',
        'fflate',
        '@preact/signals',
        'three-mesh-bvh',
        'react',
        'react/jsx-runtime',
        'react-dom/client',
        '@react-three/fiber',
        '@react-three/drei/core/Clone',
        '@gltf-transform/core',
        '@gltf-transform/extensions',
        'comlink',
        'fast-png',
        'furrow-files > ktx-parse',
        'gltf-validator',
        'draco3d',
        'meshoptimizer/decoder',
        ...babylonModules(),
      ],
      // The plugin `mtoonNodes` changes the first module. The others load WebAssembly by a path relative to their source file.
      exclude: ['@pixiv/three-vrm-materials-mtoon/nodes', 'ktx2-encoder', '@bokuweb/zstd-wasm'],
    },
    test: {
      name,
      include,
      provide,
      ...LATE,
      fileParallelism: false,
      browser: {
        connectTimeout: LATE.hookTimeout,
        enabled: true,
        headless: true,
        screenshotFailures: false,
        provider: playwright({
          launchOptions: {
            executablePath: process.env.FURROW_CHROMIUM ?? '/usr/bin/chromium',
            args: [...CHROMIUM_FLAGS],
          },
        }),
        instances: [{ browser: 'chromium' }],
      },
    },
  }
}

/** Runs a project in a browser other than Chromium. */
function onBrowser(
  kind: BrowserKind,
  project: TestProjectInlineConfiguration,
): TestProjectInlineConfiguration {
  const browser = {
    ...project.test!.browser!,
    headless: false,
    provider: driven(kind),
    instances: [{ browser: kind.name }],
  }
  return { ...project, test: { ...project.test, browser, provide: { ...provide, mayLackWebGPU: true } } }
}
