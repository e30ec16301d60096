// Writes the table of docs/auto-formats.md: which areas `furrow auto` makes under the names of each rig. `npm run rig-table`.

import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { bundle } from './lib/bundle.mjs'
import { main, ROOT, say } from './lib/run.mjs'

await main(async () => {
  const { HEAD, PAGE, readFace, ROWS, rowOf, withTable } = await import(
    await bundle('test/rigs/rig-table.ts')
  )
  const face = await readFace(ROOT)
  const rows = Object.keys(ROWS).map((name) => {
    say(name)
    return rowOf(name, face)
  })
  const page = join(ROOT, PAGE)
  writeFileSync(page, withTable(readFileSync(page, 'utf8'), [...HEAD, ...rows]))
})
