// `npm run rig-table`: updates the table of docs/auto-formats.md. It lists the areas that `furrow auto` generates from
// the blendshape names of each rig.

import { importSource } from './lib/import-source.mjs'
import { writeTable } from './lib/marked-table.mjs'
import { main, ROOT, say } from './lib/run.mjs'

await main(async () => {
  const { HEAD, readFace, ROWS, rowOf } = await importSource('test/rigs/rig-table.ts')
  const face = await readFace(ROOT)
  const rows = Object.keys(ROWS).map((name) => {
    say(name)
    return rowOf(name, face)
  })
  writeTable('docs/auto-formats.md', 'rigs', [...HEAD, ...rows])
})
