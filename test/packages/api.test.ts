import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { afterAll, beforeAll, expect, it } from 'vitest'
import { ROOT, remove, run, temporaryFolder } from './npm.ts'

let folder: string
beforeAll(async () => {
  folder = await temporaryFolder()
})
afterAll(() => remove(folder))

it('every export has a summary, and every entry point a page', async () => {
  // Fails if a comment is missing: see packages/furrow/typedoc.jsonc.
  await run(ROOT, 'npm', 'run', 'api', '--', '--out', folder)
  const { exports } = JSON.parse(readFileSync(join(ROOT, 'packages/furrow/package.json'), 'utf8'))
  const entries = Object.keys(exports).filter((entry) => entry !== './package.json')
  const pages = entries.map((entry) => `furrow${entry.slice(1).replaceAll('/', '.')}.md`)
  expect(readdirSync(folder).sort()).toEqual(['README.md', ...pages].sort())
})
