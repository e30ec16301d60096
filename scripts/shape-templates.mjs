// `npm run shape-templates`: writes the templates with which Furrow recognises blendshapes by their motion. Computes
// them from the shipped faces and from a scanned face outside the repository.

import { existsSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { importSource } from './lib/import-source.mjs'
import { Failure, main, ROOT, say } from './lib/run.mjs'

const TABLE = 'packages/furrow/src/author/shapes/templates/template-data.ts'

await main(async () => {
  const source = await importSource('scripts/lib/shape-templates.ts')
  const entries = []
  for (const [name, faces] of Object.entries(source.TEMPLATE_FACES)) {
    const missing = faces.find((face) => !existsSync(face))
    if (missing) throw new Failure(`missing face, got no ${missing}; add the file`)
    entries.push(`  ${name}:\n    '${await source.templateText(faces)}',\n`)
  }
  const text = `/*!
 * Typical motions of ARKit shapes, encoded by \`template-code.ts\`. This file is written by \`npm run shape-templates\`. \`builder\` is the mean of
 * the faces that ship with Furrow (CC0 1.0). \`scan\` is derived from ICT-FaceKit, under this licence:
 *
 * ${source.SCAN_LICENCE.join('\n * ').replaceAll(/ +$/gm, '')}
 */
export const TEMPLATES = {
${entries.join('')}}
`
  writeFileSync(join(ROOT, TABLE), text)
  say(`${TABLE}: ${text.length} bytes`)
})
