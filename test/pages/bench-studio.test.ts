import { execFile } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { promisify } from 'node:util'
import { afterAll, expect, it } from 'vitest'

const folder = mkdtempSync(join(tmpdir(), 'furrow-bench-'))
afterAll(() => rmSync(folder, { recursive: true }))

const runBench = (...args: string[]) =>
  promisify(execFile)(process.execPath, ['bench/studio/run.mjs', '--quick', ...args])

interface Results {
  about: { adapter: string; browser: string }
  results: { figure: string; medians: { now: { submitted: number; seen?: number } } }[]
}

it('paints in the built studio, and reports when each dab was shown', async () => {
  const json = join(folder, 'results.json')
  const { stdout } = await runBench('--only', 'painting', '--only', 'sizes', '--json', json)
  const { about, results }: Results = JSON.parse(readFileSync(json, 'utf8'))
  expect(about.adapter).not.toBe('')
  const now = (figure: string) => results.find((result) => result.figure === figure)!.medians.now
  for (const figure of [
    'first dab, at once',
    'first dab of the next stroke',
    'dab',
    'undo a brush stroke',
    'redo a brush stroke',
  ]) {
    const { submitted, seen } = now(figure)
    expect(submitted).toBeGreaterThan(0)
    expect(seen).toBeGreaterThan(submitted)
  }
  expect(now('first load, kB').submitted).toBeGreaterThan(100)
  expect(stdout).toContain('| figure | now | drawn | goal |')
})

it('refuses an unknown case', async () => {
  await expect(runBench('--only', 'flying')).rejects.toThrow('unknown case, got "flying", allowed: opening, ')
})
