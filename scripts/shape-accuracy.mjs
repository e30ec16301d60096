// Prints the table of bench/shapes.md: `npm run shape-accuracy -- FOLDER [FIRST LAST]`. The folder has heads by `faces/sample_heads.py`.

import { existsSync } from 'node:fs'
import { importSource } from './lib/import-source.mjs'
import { Failure, main } from './lib/run.mjs'

const [folder, first = '101', last = '140'] = process.argv.slice(2)

await main(async () => {
  if (!folder || !existsSync(folder)) throw new Failure('name a folder with heads by faces/sample_heads.py')
  const source = await importSource('scripts/lib/shape-accuracy.ts')
  console.info(
    '| head | templates | shapes | right | unknown | wrong | shapes that matter | wrong above 0.7 |',
  )
  console.info('| --- | --- | --- | --- | --- | --- | --- | --- |')
  for await (const row of source.accuracyOf(folder, [Number(first), Number(last)]))
    console.info(source.lineOf(row))
})
