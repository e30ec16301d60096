// `npm run shape-accuracy -- FOLDER [FIRST LAST]`: prints the table of bench/shapes.md. `faces/sample_heads.py` writes
// the heads in FOLDER.

import { existsSync } from 'node:fs'
import { importSource } from './lib/import-source.mjs'
import { Failure, main } from './lib/run.mjs'

const [folder, first = '101', last = '140'] = process.argv.slice(2)

await main(async () => {
  if (!folder || !existsSync(folder))
    throw new Failure(`missing folder, got "${folder ?? ''}"; name a folder written by faces/sample_heads.py`)
  const source = await importSource('scripts/lib/shape-accuracy.ts')
  console.info('| head | templates | shapes | right | unknown | wrong | key shapes | wrong above 0.7 |')
  console.info('| --- | --- | --- | --- | --- | --- | --- | --- |')
  for await (const row of source.accuracyOf(folder, [Number(first), Number(last)]))
    console.info(source.formatRow(row))
})
