import { readFileSync } from 'node:fs'
import { mkdtemp, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join, relative } from 'node:path'
import { must, ROOT } from './run.mjs'

/** How unit tests are named that `npm test` leaves out. */
const HEAVY = '.heavy.test.ts'

/** Tests in browsers that `npm test` runs: those that hold the promises of README. It leaves out all others. */
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
  'test/pages/studio-path.test.ts',
]

/** Unit tests that have more random cases in `npm run test:all`. */
export const MORE_CASES = [
  'test/unit/author/strokes-schema.test.ts',
  'test/unit/cli/fuzz.test.ts',
  'test/unit/core/wrinkles-schema.test.ts',
  'test/unit/gltf/bad-input.test.ts',
  'test/unit/gltf/specification.test.ts',
]

/** Whether `npm test` runs a file in a project. */
export function isQuick({ project, file }) {
  return project === 'unit' ? !file.endsWith(HEAVY) : project === folderOf(file) && PROMISES.includes(file)
}

/** Whether `npm run test:all` runs it: what is left out, and what has more renderers or more random cases there. */
export function isInAll(test) {
  return !isQuick(test) || folderOf(test.file) === 'gpu' || MORE_CASES.includes(test.file)
}

/** All files of tests with the project that runs each, in a lasting order: `{ project, file }[]`. */
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

/** Vitest's command, without npx, which takes half a second. */
export const VITEST = [process.execPath, 'node_modules/vitest/vitest.mjs']

/** The browser that Vitest adds to a project's name: `gpu (chromium)`. */
export const BROWSER = / \(.*\)$/

const folderOf = (file) => file.split('/')[1]
