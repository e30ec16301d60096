import { spawnSync } from 'node:child_process'
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { subjectProblem } from '../../scripts/lib/commit-subject.mjs'

test.each([
  ['Keep the brush size when the tool changes'],
  ['x'.repeat(72)],
  ['Fix the seam\n\nThe border was one texel short.\n# a comment of git'],
  [`Revert "${'x'.repeat(72)}"`],
])('subject %j is accepted', (message) => expect(subjectProblem(message)).toBeUndefined())

test.each([
  ['x'.repeat(73), 'subject too long, got 73 characters, allowed: 72'],
  ['Fix the seam.', 'full stop'],
  ['Fix the seam\nThe border was one texel short.', 'empty line'],
])('subject %j is refused', (message, problem) => expect(subjectProblem(message)).toContain(problem))

test('the commit-msg hook refuses a long subject in one line', () => {
  const folder = mkdtempSync(join(tmpdir(), 'furrow-commit-'))
  try {
    const file = join(folder, 'COMMIT_EDITMSG')
    const commit = (message: string) => {
      writeFileSync(file, message)
      return spawnSync('sh', ['.githooks/commit-msg', file], { encoding: 'utf8' })
    }
    expect(commit('Fix the seam\n').status).toBe(0)
    const { status, stderr } = commit(`${'x'.repeat(80)}\n`)
    expect(status).toBe(1)
    expect(stderr).toBe(
      'furrow: commit: subject too long, got 80 characters, allowed: 72; move details to the body\n',
    )
  } finally {
    rmSync(folder, { recursive: true })
  }
})
