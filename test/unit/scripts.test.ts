import { spawnSync } from 'node:child_process'
import { expect, test } from 'vitest'

const WHOLE = 'is not a whole number, got'

test.each([
  ['fuzz', '--first', '1.5', `--first ${WHOLE} "1.5", allowed: at least 0; write e.g. --first 20`],
  ['interrupt', '--moments', '', `--moments ${WHOLE} "", allowed: at least 1; write e.g. --moments 20`],
  [
    'blender',
    '--version',
    '2.8',
    '--version is unsupported, got "2.8", allowed: 4.5 or 5.0; write e.g. --version 4.5',
  ],
  ['fuzz', '--cuont', '5', expect.stringContaining("Unknown option '--cuont'")],
])('npm run %s -- %s %s is refused in one line', (script, option, value, line) => {
  const { status, stderr } = spawnSync(process.execPath, [`scripts/${script}.mjs`, option, value], {
    encoding: 'utf8',
  })
  expect(status).toBe(1)
  expect(stderr.trimEnd().split('\n')).toEqual([typeof line === 'string' ? `furrow: ${line}` : line])
})
