// `npm run prose` lists sentences of over 30 words and comments without a subject, in all files or in those named after `--`.

import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { faultsOf } from './lib/prose.mjs'
import { Failure, main, ROOT } from './lib/run.mjs'

const CHECKED = /\.(ts|tsx|mjs|js|py|md)$/

await main(() => {
  const paths = execFileSync('git', ['ls-files', ...process.argv.slice(2)], {
    cwd: ROOT,
    encoding: 'utf8',
  }).split('\n')
  let count = 0
  for (const path of paths.filter((path) => CHECKED.test(path))) {
    for (const { line, fault, sentence } of faultsOf(path, readFileSync(join(ROOT, path), 'utf8'))) {
      console.error(`${path}:${line}: ${fault}: ${sentence}`)
      count++
    }
  }
  if (count > 0)
    throw new Failure(
      `prose: ${count} sentences to write again, allowed: none; docs have the rules in CONTRIBUTING.md`,
    )
})
