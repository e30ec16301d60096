import { existsSync, readdirSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { beforeAll, expect, it } from 'vitest'
import { changedFirst } from '../../scripts/lib/changed-tests.mjs'
import {
  isInAll,
  isQuick,
  listTests,
  MORE_CASES,
  PROMISES,
  type TestFile,
} from '../../scripts/lib/test-files.mjs'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))

let tests: TestFile[]

beforeAll(async () => {
  tests = await listTests()
})

it('every test file is run by npm test or by npm run test:all', () => {
  const run = new Set(tests.filter((test) => isQuick(test) || isInAll(test)).map(({ file }) => file))
  const files = readdirSync(join(ROOT, 'test'), { recursive: true, encoding: 'utf8' })
    .map((file) => `test/${file.replaceAll('\\', '/')}`)
    .filter((file) => file.endsWith('.test.ts'))
  expect(files.length).toBeGreaterThan(100)
  expect(files.filter((file) => !run.has(file))).toEqual([])
})

it.each([...PROMISES, ...MORE_CASES])('%s exists, and npm test runs it', (file) => {
  expect(existsSync(join(ROOT, file))).toBe(true)
  expect(tests.filter((test) => test.file === file && isQuick(test))).toHaveLength(1)
})

it('with a time limit, the order of the tests still contains each test once', () => {
  const key = ({ project, file }: TestFile) => `${project} ${file}`
  expect(changedFirst(tests).map(key).sort()).toEqual(tests.map(key).sort())
})
