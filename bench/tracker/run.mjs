// `npm run bench:tracker`: measures `FaceTracker` on simulated takes, and prints the table of README.md. Options:
// --tune: use the persons on whom the defaults were tuned
// --write: write the table into README.md

import { parseArgs } from 'node:util'
import { importSource } from '../../scripts/lib/import-source.mjs'
import { writeTable } from '../../scripts/lib/marked-table.mjs'
import { Failure, main } from '../../scripts/lib/run.mjs'

await main(async () => {
  const options = { tune: { type: 'boolean', default: false }, write: { type: 'boolean', default: false } }
  const { tune, write } = parseArgs({ options }).values
  if (tune && write) throw new Failure('the table describes other persons than those of --tune; omit --tune')
  const { trackerTable } = await importSource('bench/tracker/table.ts')
  const lines = trackerTable(tune ? 'tuned' : 'tested')
  if (write) writeTable('bench/tracker/README.md', 'tracker', lines)
  else for (const line of lines) console.info(line)
})
