import { readFileSync } from 'node:fs'
import { mkdtemp, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join, relative } from 'node:path'
import { must, ROOT } from './run.mjs'

/** End of the names of unit tests that `npm test` skips. */
const HEAVY = '.heavy.test.ts'

/**
 * Browser tests that `npm test` runs. They check what the README promises. `npm test` skips all other browser tests.
 */
export const PROMISES = [
  'test/gpu/influence.test.ts',
  'test/gpu/layers.test.ts',
  'test/gpu/maps.test.ts',
  'test/gpu/material.test.ts',
  'test/gpu/mtoon.test.ts',
  'test/gpu/composed.test.ts',
  'test/gpu/fallback.test.ts',
  'test/gpu/crowd.test.ts',
  'test/gpu/features.test.ts',
  'test/gpu/export.test.ts',
  'test/gpu/same-bytes.test.ts',
  'test/gpu/react.test.ts',
  'test/gpu/loader/loader.test.ts',
  'test/gpu/loader/damaged.test.ts',
  'test/gpu/relief/relief.test.ts',
  'test/gpu/conformance/three.test.ts',
  'test/gpu/conformance/babylon.test.ts',
  'test/gpu/babylon/influence.test.ts',
  'test/gpu/babylon/loader.test.ts',
  'test/pages/examples.test.ts',
  'test/pages/studio-path.test.ts',
]

/** Unit tests that run more random cases in `npm run test:all`. */
export const MORE_CASES = [
  'test/unit/author/preset.test.ts',
  'test/unit/author/strokes-schema.test.ts',
  'test/unit/cli/fuzz.test.ts',
  'test/unit/core/wrinkles-schema.test.ts',
  'test/unit/gltf/bad-input.test.ts',
  'test/unit/gltf/specification.test.ts',
]

/** Returns whether `npm test` runs a file. */
export function isQuick({ project, file }) {
  return project === 'unit' ? !file.endsWith(HEAVY) : project === folderOf(file) && PROMISES.includes(file)
}

/**
 * Returns whether `npm run test:all` runs a file. It runs files that `npm test` skips, and files that `npm test` runs
 * with fewer renderers or random cases.
 */
export function isInAll(test) {
  return !isQuick(test) || folderOf(test.file) === 'gpu' || MORE_CASES.includes(test.file)
}

/** Returns all test files as `{ project, file }`, in a deterministic order. */
export async function listTests() {
  const folder = await mkdtemp(join(tmpdir(), 'furrow-tests-'))
  const list = join(folder, 'list.json')
  try {
    const env = { ...process.env, FURROW_TESTS: 'all' }
    await must([...VITEST, 'list', '--filesOnly', `--json=${list}`], { quiet: true, env })
    const key = ({ project, file }) => `${project} ${file}`
    return JSON.parse(readFileSync(list, 'utf8'))
      .map(({ file, projectName }) => ({
        project: projectName.replace(BROWSER, ''),
        file: relative(ROOT, file).replaceAll('\\', '/'),
      }))
      .sort((a, b) => (key(a) < key(b) ? -1 : 1))
  } finally {
    await rm(folder, { recursive: true })
  }
}

/** Command of Vitest. Runs without npx, which would take half a second. */
export const VITEST = [process.execPath, 'node_modules/vitest/vitest.mjs']

/** Suffix that Vitest appends to the name of a project, e.g. in `gpu (chromium)`. */
export const BROWSER = / \(.*\)$/

const folderOf = (file) => file.split('/')[1]
