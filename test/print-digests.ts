// Makes automatic wrinkles for the faces of `auto-digest.ts`, and prints a hash of each step as JSON: node print-digests.mjs human.glb small-head.glb

import { readFileSync } from 'node:fs'
import { basename } from 'node:path'
import { autoDigest, type DigestedFace } from './auto-digest.ts'

const digests: Record<string, unknown> = {}
for (const path of process.argv.slice(2)) {
  const name = basename(path)
  digests[name] = await autoDigest(name as DigestedFace, readFileSync(path))
}
process.stdout.write(JSON.stringify(digests))
