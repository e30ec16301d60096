// `npm run fuzz -- --count 5000 --seed 1 --command auto`: runs commands on damaged files. Equal seeds produce equal
// files.

import { mkdirSync, rmdirSync } from 'node:fs'
import { availableParallelism, tmpdir } from 'node:os'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { bundle } from './lib/bundle.mjs'
import { Failure, main, say } from './lib/run.mjs'
import { wholeNumber } from './lib/whole-number.mjs'

await main(async () => {
  const { values } = parseArgs({
    options: {
      command: { type: 'string', multiple: true },
      count: { type: 'string', default: '100' },
      seed: { type: 'string', default: '1' },
      first: { type: 'string', default: '0' },
      seconds: { type: 'string', default: '10' },
      jobs: { type: 'string', default: String(availableParallelism()) },
    },
  })
  const [seed, first] = ['seed', 'first'].map((option) => wholeNumber(option, values[option], 0))
  const [count, seconds, jobs] = ['count', 'seconds', 'jobs'].map((option) =>
    wholeNumber(option, values[option], 1),
  )
  const { fuzz } = await import(await bundle('test/fuzz/fuzz.ts'))
  const keep = join(tmpdir(), `furrow-fuzz-failures-${process.pid}`)
  mkdirSync(keep)
  const stop = new AbortController()
  for (const signal of ['SIGINT', 'SIGTERM']) process.once(signal, () => stop.abort())
  const results = await fuzz({
    child: await bundle('test/fuzz/child.ts'),
    ...(values.command && { commands: values.command }),
    seed,
    first,
    count,
    limits: { seconds, megabytes: 1024 },
    jobs,
    keep,
    report: say,
    stop: stop.signal,
  })
  const failures = results.reduce((sum, { failures }) => sum + failures.length, 0)
  if (failures === 0) rmdirSync(keep)
  if (failures > 0) throw new Failure(`${failures} files failed; they are in ${keep}`)
  if (stop.signal.aborted) throw new Failure('stopped early')
})
