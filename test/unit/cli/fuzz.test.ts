import { mkdtempSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { beforeAll, expect, inject, test } from 'vitest'
import { bundle } from '../../../scripts/lib/bundle.mjs'
import { COMMANDS } from '../../fuzz/cases.ts'
import { type CommandResults, fuzz } from '../../fuzz/fuzz.ts'

// For a longer run: `npm run fuzz -- --count 5000 --seed 2 --command auto`.
const IN_DEPTH = inject('inDepth')
const COUNT = IN_DEPTH ? 100 : 8
const SEED = 1
const keep = mkdtempSync(join(tmpdir(), 'furrow-fuzz-failures-'))
const lines: string[] = []
let results: CommandResults[]

const fuzzed = async (child: string, commands: string[], report?: (text: string) => void) => {
  const limits = { seconds: 10, megabytes: 1024 }
  return fuzz({ child, commands, seed: SEED, count: COUNT, limits, jobs: 1, keep, report })
}

beforeAll(async () => {
  results = await fuzzed(await bundle('test/fuzz/child.ts'), [...COMMANDS], (text) => lines.push(text))
}, 30 * 60_000)

test.each(COMMANDS)('%s: a damaged file leads to success, an error of one line, or a finding', (command) => {
  const { failures, tried } = results.find((each) => each.command === command)!
  expect(failures, `seed ${SEED}; the files are in ${keep}\n${lines.join('\n')}`).toEqual([])
  expect(tried).toHaveLength(COUNT)
  // If a command refused every file, the run would prove little. A short run may have no success by chance.
  const successes = tried.filter(({ outcome }) => outcome === 'success')
  if (IN_DEPTH) expect(successes.length).toBeGreaterThan(0)
})

test('a command that reads no files is refused', async () => {
  await expect(fuzzed('', ['auto', 'rendr'])).rejects.toThrow(
    /^fuzz: no command of that name reads files, got "rendr", allowed: activations, .*; name one of these$/,
  )
})
