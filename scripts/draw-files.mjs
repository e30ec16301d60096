// `npm run draw-files -- --seed 1 --to FOLDER`: copies 20 random files into a folder, so that people can review the
// prose in them. `list.txt` in the folder lists the files and their numbers of words.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { basename, join } from 'node:path'
import { parseArgs } from 'node:util'
import { importSource } from './lib/import-source.mjs'
import { checkedFiles, countProse } from './lib/prose.mjs'
import { Failure, main, ROOT, say } from './lib/run.mjs'
import { wholeNumber } from './lib/whole-number.mjs'

const COUNT = 20

/** Files with fewer words of prose are not copied. */
const FEWEST = 100

await main(async () => {
  const { values } = parseArgs({ options: { seed: { type: 'string' }, to: { type: 'string' } } })
  if (values.to === undefined) throw new Failure('draw-files: --to is missing; write e.g. --to review')
  const seed = wholeNumber('seed', values.seed ?? '', 0)
  const { seeded } = await importSource('test/random.ts')
  const files = checkedFiles()
    .map((path) => ({ path, text: readFileSync(join(ROOT, path), 'utf8') }))
    .map((file) => ({ ...file, words: countProse(file.path, file.text) }))
    .filter(({ words }) => words >= FEWEST)
  const drawn = draw(files, seeded(seed))
  mkdirSync(values.to, { recursive: true })
  for (const [i, { path, text }] of drawn.entries())
    writeFileSync(join(values.to, `${String(i + 1).padStart(2, '0')}-${basename(path)}`), text)
  writeFileSync(join(values.to, 'list.txt'), drawn.map(({ path, words }) => `${words}\t${path}\n`).join(''))
  const total = drawn.reduce((sum, { words }) => sum + words, 0)
  say(`${COUNT} of ${files.length} files, ${total} words of prose, in ${values.to}`)
})

/** Picks `COUNT` different files at random. */
function draw(files, random) {
  const left = [...files]
  return Array.from({ length: COUNT }, () => left.splice(Math.floor(random() * left.length), 1)[0])
}
