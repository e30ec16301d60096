// `npm run schema`: copies the JSON schemas of all driver types to docs/schema, and lists the driver types in the
// schema that they share.

import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { runnerImport } from 'vite'
import { ROOT } from './lib/run.mjs'

const { module } = await runnerImport(join(ROOT, 'packages/furrow/src/drivers/registry.ts'))
const { DRIVER_TYPES } = module

const published = (name) => join(ROOT, `docs/schema/FURROW_wrinkle_maps.driver${name}.schema.json`)

for (const type of DRIVER_TYPES) {
  const schema = readFileSync(join(ROOT, `packages/furrow/src/drivers/${type}/schema.json`))
  writeFileSync(published(`.${type}`), schema)
}
const list = JSON.parse(readFileSync(published(''), 'utf8'))
list.allOf = DRIVER_TYPES.map((type) => ({
  if: { properties: { type: { const: type } } },
  // biome-ignore lint/suspicious/noThenProperty: a keyword of JSON Schema
  then: { $ref: `FURROW_wrinkle_maps.driver.${type}.schema.json` },
}))
writeFileSync(published(''), `${JSON.stringify(list, null, 2)}\n`)
