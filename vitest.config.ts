import { readdirSync, readFileSync } from 'node:fs'
import { playwright } from '@vitest/browser-playwright'
import { defineConfig, type TestProjectInlineConfiguration } from 'vitest/config'
import { CHROMIUM_FLAGS } from './packages/cli/src/chromium-flags.ts'
import { SOURCES } from './scripts/lib/sources.mjs'
import { mtoonNodes } from './test/gpu/mtoon-nodes.ts'
import { FILES_FOR_OLDEST, onOldestThree } from './test/gpu/oldest-three.ts'
import { serveFaces } from './test/gpu/serve-faces.ts'
import { GPU_FILES_IN_DEPTH, inDepth, UNIT_FILES_IN_DEPTH } from './test/in-depth.ts'

const { resolve, ssr } = SOURCES

// Milliseconds. Limits guard against a hang and no more: a slow or busy machine is no fault.
const SOON = { testTimeout: 300_000, hookTimeout: 300_000 }
const LATE = { testTimeout: 900_000, hookTimeout: 900_000 }

// By default Vitest leaves one core idle, which is half of two.
const ALL_CORES = { maxWorkers: '100%' }
const HEAVY = 'test/unit/**/*.heavy.test.ts'
const HEAVY_GPU = 'test/gpu/**/*.heavy.test.ts'
const HEAVY_PAGES = 'test/pages/**/*.heavy.test.ts'
const HEAVY_PACKAGES = 'test/packages/**/*.heavy.test.ts'

export default defineConfig({
  test: {
    projects: [
      {
        resolve,
        ssr,
        test: { name: 'unit', include: ['test/unit/**/*.test.ts'], exclude: [HEAVY], ...SOON, ...ALL_CORES },
      },
      {
        resolve,
        ssr,
        // What meets Node itself; arithmetic, damaged input and what files mean are the same on every release.
        test: {
          name: 'lts',
          include: ['test/unit/{auto,cli,core,gltf,runtime}/**/*.test.ts', 'test/unit/scripts.test.ts'],
          exclude: [HEAVY, '**/{fuzz,bad-input,validate,vrm}.test.ts'],
          ...SOON,
          ...ALL_CORES,
        },
      },
      inDepth({
        resolve,
        ssr,
        test: { name: 'heavy', include: [HEAVY, ...UNIT_FILES_IN_DEPTH], ...SOON, ...ALL_CORES },
      }),
      packagesProject('packages', 'test/packages/**/*.test.ts', [HEAVY_PACKAGES]),
      packagesProject('heavy-packages', HEAVY_PACKAGES),
      pagesProject('pages', 'test/pages/**/*.test.ts', [HEAVY_PAGES]),
      pagesProject('heavy-pages', HEAVY_PAGES),
      // In two browsers, side by side: each has one test after the other, which keeps one core busy.
      gpuProject('gpu', ['test/gpu/*.test.ts'], [HEAVY_GPU]),
      gpuProject('gpu-rooms', ['test/gpu/*/**/*.test.ts'], [HEAVY_GPU]),
      inDepth(gpuProject('heavy-gpu', [HEAVY_GPU, ...GPU_FILES_IN_DEPTH])),
      pagesProject('batch', 'test/batch/**/*.test.ts'),
      pagesProject('site', 'test/site/**/*.test.ts'),
      inDepth(onOldestThree(gpuProject('gpu-oldest', FILES_FOR_OLDEST))),
    ],
  },
})

/** Applications that install what npm publishes, beside each other like the unit tests: they mostly wait for npm. */
function packagesProject(
  name: string,
  include: string,
  exclude: string[] = [],
): TestProjectInlineConfiguration {
  const globalSetup = 'test/packages/tarballs.ts'
  return { resolve, ssr, test: { name, include: [include], exclude, globalSetup, ...LATE, ...ALL_CORES } }
}

/** Whole pages and commands, one at a time. */
function pagesProject(name: string, include: string, exclude: string[] = []): TestProjectInlineConfiguration {
  // What a page shows comes when it has been drawn, which a busy machine takes more than a second for.
  const poll = { timeout: 120_000 }
  return {
    resolve,
    ssr,
    test: { name, include: [include], exclude, ...LATE, expect: { poll }, fileParallelism: false },
  }
}

/** The modules of Babylon.js that are imported: each by its path, as its applications do. */
function babylonModules(): string[] {
  const folders = ['packages/furrow/src/babylon', 'test/gpu/babylon', 'test/gpu/conformance']
  const texts = folders.flatMap((folder) =>
    readdirSync(folder, { recursive: true, encoding: 'utf8' })
      .filter((path) => path.endsWith('.ts'))
      .map((path) => readFileSync(`${folder}/${path}`, 'utf8')),
  )
  // Those of which only types are imported are gone when the code runs.
  const imports = texts.flatMap((text) => [
    ...text.matchAll(/^(?:import|} from) (?!type)(?:.* from )?'(@babylonjs[^']+)'/gm),
  ])
  return [...new Set(imports.map(([, name]) => name))]
}

/** A project in the browser, on three paths. */
function gpuProject(name: string, files: string[], exclude: string[] = []): TestProjectInlineConfiguration {
  return {
    resolve,
    ssr,
    plugins: [serveFaces(ssr), mtoonNodes()],
    optimizeDeps: {
      // What is found late is optimised then, and reloads the page in the middle of a test: what is not listed is served as it is.
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
        'fastest-levenshtein',
        'furrow-files > ktx-parse',
        'gltf-validator',
        'draco3d',
        'meshoptimizer/decoder',
        ...babylonModules(),
      ],
      // The first is changed by `mtoonNodes`; the others find their WebAssembly beside their own modules.
      exclude: ['@pixiv/three-vrm-materials-mtoon/nodes', 'ktx2-encoder', '@bokuweb/zstd-wasm'],
    },
    test: {
      name,
      include: files,
      exclude,
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
