// `npm run prose`: lists sentences of over 30 words, and comments without a subject. `-- PATH...` selects files.

import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { checkedFiles, findProblems } from './lib/prose.mjs'
import { Failure, main, ROOT } from './lib/run.mjs'

await main(() => {
  let count = 0
  for (const path of checkedFiles(process.argv.slice(2))) {
    for (const { line, problem, sentence } of findProblems(path, readFileSync(join(ROOT, path), 'utf8'))) {
      console.error(`${path}:${line}: ${problem}: ${sentence}`)
      count++
    }
  }
  if (count > 0)
    throw new Failure(`prose: ${count} unclear sentences, allowed: none; see CONTRIBUTING.md for the rules`)
})
