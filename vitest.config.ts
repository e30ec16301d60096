import { existsSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { fileURLToPath } from 'node:url'
import { playwright } from '@vitest/browser-playwright'
import { defineConfig } from 'vitest/config'
import { CHROMIUM_FLAGS } from './packages/cli/src/chromium-flags.ts'

// Sources, not builds: the `furrow-source` condition of the packages' exports.
const resolve = { conditions: ['furrow-source', 'module', 'browser', 'development|production'] }
const ssr = { resolve: { conditions: ['furrow-source', 'module', 'node', 'development|production'] } }

// Milliseconds. Limits guard against a hang and no more: a slow or busy machine is no fault.
const SOON = { testTimeout: 300_000, hookTimeout: 300_000 }
const LATE = { testTimeout: 900_000, hookTimeout: 900_000 }

/** A scanned face that is tested where it is at hand; it is data of others and no part of this repository. */
const realFace = fileURLToPath(new URL('../shared/real-face/ict-face.glb', import.meta.url))

export default defineConfig({
  test: {
    projects: [
      { resolve, ssr, test: { name: 'unit', include: ['test/unit/**/*.test.ts'], ...SOON } },
      { test: { name: 'packages', include: ['test/packages/**/*.test.ts'], ...LATE } },
      {
        resolve,
        ssr,
        test: {
          name: 'pages',
          include: ['test/pages/**/*.test.ts'],
          ...LATE,
          fileParallelism: false,
        },
      },
      {
        resolve,
        define: { __REAL_FACE__: JSON.stringify(existsSync(realFace) ? `/@fs${realFace}` : '') },
        optimizeDeps: {
          include: [
            'three',
            'three/webgpu',
            'three/tsl',
            'three/addons/libs/meshopt_decoder.module.js',
            'three/addons/loaders/GLTFLoader.js',
            'three/addons/loaders/KTX2Loader.js',
            'three/addons/loaders/DRACOLoader.js',
            'three/addons/utils/SkeletonUtils.js',
          ],
        },
        server: { fs: { allow: ['..', tmpdir()] } },
        test: {
          name: 'gpu',
          include: ['test/gpu/**/*.test.ts'],
          globalSetup: 'test/gpu/pack-faces.ts',
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
      },
    ],
  },
})
