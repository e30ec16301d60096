// `npm run prose`: lists sentences of over 30 words and comments without a subject. `-- PATH...` selects files.

import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { findProblems } from './lib/prose.mjs'
import { Failure, main, ROOT } from './lib/run.mjs'

const CHECKED = /\.(ts|tsx|mjs|js|py|md)$/

/** A licence, and pages that are being replaced. */
const SKIPPED = /templates\/template-data\.ts$|^docs\/(auto|studio)\.md$/

await main(() => {
  const paths = execFileSync('git', ['ls-files', ...process.argv.slice(2)], {
    cwd: ROOT,
    encoding: 'utf8',
  }).split('\n')
  let count = 0
  for (const path of paths.filter((path) => CHECKED.test(path) && !SKIPPED.test(path))) {
    for (const { line, problem, sentence } of findProblems(path, readFileSync(join(ROOT, path), 'utf8'))) {
      console.error(`${path}:${line}: ${problem}: ${sentence}`)
      count++
    }
  }
  if (count > 0)
    throw new Failure(`prose: ${count} unclear sentences, allowed: none; see CONTRIBUTING.md for the rules`)
})
