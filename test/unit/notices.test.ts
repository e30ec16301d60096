import { execFile } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { promisify } from 'node:util'
import { expect, it } from 'vitest'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const CLI = join(ROOT, 'packages/cli')
const COMMITTED = readFileSync(join(CLI, 'THIRD_PARTY_NOTICES.md'), 'utf8')

it('the notices of furrow-cli equal those collected from the installed packages', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'furrow-notices-'))
  try {
    const file = join(folder, 'notices.md')
    await promisify(execFile)(process.execPath, [join(ROOT, 'scripts/notices.mjs'), file])
    expect(COMMITTED, 'out of date: npm run notices').toBe(readFileSync(file, 'utf8'))
  } finally {
    rmSync(folder, { recursive: true })
  }
})

const { dependencies } = JSON.parse(readFileSync(join(CLI, 'package.json'), 'utf8'))

it('furrow-cli installs the dependencies of furrow-files, which is bundled into it', () => {
  const files = JSON.parse(readFileSync(join(ROOT, 'packages/files/package.json'), 'utf8'))
  const { furrow, ...needed } = files.dependencies
  expect(Object.keys(needed).length).toBeGreaterThan(5)
  expect(dependencies).toMatchObject(needed)
})

it.each(Object.entries<string>(dependencies))('the licence of %s %s is included', (name, version) => {
  expect(COMMITTED).toContain(`\n- ${name} ${version}: `)
  const section = COMMITTED.split('\n## ').find((one) => one.split('\n', 1)[0].split(', ').includes(name))
  expect(section).toMatch(/MIT|Apache License|Permission is (hereby )?granted/)
})
