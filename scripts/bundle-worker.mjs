// Puts the worker of `furrow/auto` into the built package as one string, see packages/furrow/src/auto/start-worker.ts.

import { createHash } from 'node:crypto'
import { rm, writeFile } from 'node:fs/promises'
import { join } from 'node:path'
import { build } from 'vite'
import { ROOT } from './lib/run.mjs'

const FOLDER = join(ROOT, 'packages/furrow/dist/auto')

const [{ output }] = await build({
  root: FOLDER,
  configFile: false,
  logLevel: 'warn',
  build: { write: false, lib: { entry: 'worker.js', formats: ['iife'], name: 'worker' } },
})

const [{ code }] = output
const file = join(FOLDER, 'start-worker.js')
await writeFile(
  file,
  `const SOURCE = ${JSON.stringify(code)}

/** Of the code in the worker. */
export const version = '${createHash('sha256').update(code).digest('hex').slice(0, 16)}'

let address

/** Starts the worker. The address is kept for the next one. */
export function startWorker() {
  address ??= URL.createObjectURL(new Blob([SOURCE], { type: 'text/javascript' }))
  return new Worker(address)
}
`,
)
// That of the replaced file.
await rm(`${file}.map`)
