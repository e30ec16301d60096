import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { afterAll, beforeAll, expect, it } from 'vitest'
import { ROOT, remove, run, temporaryFolder } from './npm.ts'

let folder: string
beforeAll(async () => {
  folder = await temporaryFolder()
})
afterAll(() => remove(folder))

it('docs/api is what the sources say, and they say something of every export', async () => {
  await run(ROOT, 'npm', 'run', 'api', '--', '--out', folder)
  const pages = readdirSync(folder)
  expect(pages).toContain('furrow.md')
  expect(readdirSync(join(ROOT, 'docs/api'))).toEqual(pages)
  for (const page of pages) {
    const committed = readFileSync(join(ROOT, 'docs/api', page), 'utf8')
    expect(committed, `docs/api/${page} is not up to date: npm run api`).toBe(
      readFileSync(join(folder, page), 'utf8'),
    )
  }
})
