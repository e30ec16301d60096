// `npm run commit-subjects`: checks the subjects of the last 50 commits, and prints a warning for each subject that
// breaks the rules. The hook `.githooks/commit-msg` checks one message with `-- --message FILE`.

import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { parseArgs } from 'node:util'
import { subjectProblem } from './lib/commit-subject.mjs'
import { Failure, main, ROOT } from './lib/run.mjs'

const COUNT = 50

await main(() => {
  const { values } = parseArgs({ options: { message: { type: 'string' } } })
  if (values.message !== undefined) {
    const problem = subjectProblem(readFileSync(values.message, 'utf8'))
    if (problem) throw new Failure(`commit: ${problem}`)
    return
  }
  const log = execFileSync('git', ['log', '--no-merges', '-z', '-n', `${COUNT}`, '--format=%h%n%B'], {
    cwd: ROOT,
    encoding: 'utf8',
  })
  // GitHub turns lines with this prefix into annotations.
  const prefix = process.env.GITHUB_ACTIONS ? '::warning::' : 'furrow: '
  for (const entry of log.split('\0')) {
    const [hash, ...lines] = entry.split('\n')
    const problem = subjectProblem(lines.join('\n'))
    if (problem) console.warn(`${prefix}commit ${hash}: ${problem}`)
  }
})
