// `node bench/auto/measure.mjs face.glb 1024`: runs the steps of `furrow auto` once, with the built packages. Prints as JSON, for each stage, the
// CPU time of all threads in seconds, and the peak memory so far in megabytes.

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

/** Ends the current stage and begins `next`, unless `next` is the current stage. The first stage starts with the process. */
function begin(next) {
  if (next === stage) return
  const { user, system } = process.cpuUsage()
  const now = (user + system) / 1e6
  stages[stage] = { seconds: now - since, megabytes: process.resourceUsage().maxRSS / 1024 }
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
process.stdout.write(JSON.stringify({ stages }))
