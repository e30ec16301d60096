// `npm run rooms`: draws the graph of modules in docs/architecture.md.

import { writeFile } from 'node:fs/promises'
import { join } from 'node:path'
import { drawRooms } from './lib/room-graph.mjs'
import { main, ROOT, say } from './lib/run.mjs'

const PICTURE = 'docs/figures/rooms.svg'

await main(async () => {
  await writeFile(join(ROOT, PICTURE), await drawRooms())
  say(PICTURE)
})
