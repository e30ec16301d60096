import { spawnSync } from 'node:child_process'
import { cpSync, mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { expect, it } from 'vitest'

const BIN = fileURLToPath(new URL('../../../packages/cli/bin', import.meta.url))

it('before a build the command prints in one line what to run', () => {
  const clone = mkdtempSync(join(tmpdir(), 'furrow-unbuilt-'))
  try {
    cpSync(BIN, join(clone, 'bin'), { recursive: true })
    const { status, stderr } = spawnSync(process.execPath, [join(clone, 'bin/furrow.js'), 'auto'], {
      encoding: 'utf8',
    })
    expect(status).toBe(1)
    expect(stderr).toBe('furrow: not built yet; run "npm run build" in the root of the repository\n')
  } finally {
    rmSync(clone, { recursive: true })
  }
})
