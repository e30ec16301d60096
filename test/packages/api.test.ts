import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { afterAll, beforeAll, expect, it } from 'vitest'
import { ROOT, remove, run, temporaryFolder } from './npm.ts'

let folder: string
beforeAll(async () => {
  folder = await temporaryFolder()
})
afterAll(() => remove(folder))

it('the API reference has a summary for every export, and a page for every entry point', async () => {
  // The command fails if a comment is missing, as set in packages/furrow/typedoc.jsonc.
  await run(ROOT, 'npm', 'run', 'api', '--', '--out', folder)
  const { exports } = JSON.parse(readFileSync(join(ROOT, 'packages/furrow/package.json'), 'utf8'))
  const entries = Object.keys(exports).filter((entry) => entry !== './package.json')
  const pages = entries.map((entry) => `furrow${entry.slice(1).replaceAll('/', '.')}.md`)
  expect(readdirSync(folder).sort()).toEqual(['README.md', ...pages].sort())
})
