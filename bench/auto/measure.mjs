// Makes the wrinkles of one face as `furrow auto` does, from the packages' builds. Prints the milliseconds of each stage and the
// process's peak memory as JSON: `node bench/auto/measure.mjs face.glb 1024`.

import { mkdtemp, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { autoWrinkles } from 'furrow/author'
import { encodeGlb } from '../../packages/cli/dist/files/src/gltf/glb-file.js'
import { readDocument } from '../../packages/cli/dist/files/src/gltf/read-document.js'
import { readGlbFile } from '../../packages/cli/dist/files/src/gltf/read-glb-file.js'
import { findSkin } from '../../packages/cli/dist/files/src/mesh/find-skin.js'
import { embedWrinkles } from '../../packages/cli/dist/files/src/pack/embed.js'
import { packAuto } from '../../packages/cli/dist/files/src/pack/pack-auto.js'
import { writeAll } from '../../packages/cli/dist/files.js'

const [path, size] = process.argv.slice(2)
const WHO = 'bench'
const stages = {}
let stage = 'start'
let since = 0

/** Ends the current stage and begins the next. The first stage begins with the process; parts of a step are one stage. */
function begin(next) {
  if (next === stage) return
  const now = performance.now()
  stages[stage] = now - since
  stage = next
  since = now
}

const folder = await mkdtemp(join(tmpdir(), 'furrow-bench-'))
try {
  begin('read')
  const glb = await readGlbFile(path, WHO)
  const found = findSkin(await readDocument(path, WHO), path, WHO)
  const frame = found.hasTangents ? 'orthonormal' : 'derivative'
  const made = autoWrinkles(found.skin, { size: Number(size), frame }, (_, __, step) =>
    begin(step === 'done' ? 'encode' : step),
  )
  embedWrinkles(glb, found.material, await packAuto(made, false, WHO), WHO)
  const bytes = encodeGlb(glb)
  begin('write')
  await writeAll([{ path: join(folder, 'out.glb'), bytes }], WHO)
  begin('end')
} finally {
  await rm(folder, { recursive: true })
}
const megabytes = process.resourceUsage().maxRSS / 1024
process.stdout.write(JSON.stringify({ stages, megabytes }))
