import { mkdtempSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { beforeAll, expect, inject, test } from 'vitest'
import { bundle } from '../../../scripts/lib/bundle.mjs'
import { COMMANDS } from '../../fuzz/cases.ts'
import { fuzz } from '../../fuzz/fuzz.ts'

// More: `npm run fuzz -- --count 5000 --seed 2 --command auto`.
const IN_DEPTH = inject('inDepth')
const COUNT = IN_DEPTH ? 100 : 8
const SEED = 1

let child = ''

beforeAll(async () => {
  child = await bundle('test/fuzz/child.ts')
})

test.each(COMMANDS)('%s: damaged files end in success, one line or a finding', async (command) => {
  const keep = mkdtempSync(join(tmpdir(), 'furrow-fuzz-failures-'))
  const lines: string[] = []
  const [results] = await fuzz({
    child,
    commands: [command],
    seed: SEED,
    count: COUNT,
    limits: { seconds: 10, megabytes: 1024 },
    jobs: 1,
    keep,
    report: (text) => lines.push(text),
  })
  expect(results!.failures, `seed ${SEED}; the files are in ${keep}\n${lines.join('\n')}`).toEqual([])
  expect(results!.tried).toHaveLength(COUNT)
  // A fuzz whose files are all refused at the door tests nothing behind it; of a few files all may be.
  const successes = results!.tried.filter(({ outcome }) => outcome === 'success')
  if (IN_DEPTH) expect(successes.length).toBeGreaterThan(0)
})

test('a command that reads no files is refused', async () => {
  const options = { child, commands: ['auto', 'rendr'], seed: 1, count: 1, jobs: 1, keep: '' }
  await expect(fuzz({ ...options, limits: { seconds: 10, megabytes: 1024 } })).rejects.toThrow(
    /^fuzz: no command of that name reads files, got "rendr", allowed: activations, .*; name one of these$/,
  )
})
