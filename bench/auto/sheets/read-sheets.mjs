import { existsSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { Failure } from '../../../scripts/lib/run.mjs'
import { DESCRIPTION } from './draw-sheets.mjs'

/**
 * Reads the description of a folder of sheets, see `describeSheets`. Each part gets `files`, the path of its sheet by version. Parts of
 * missing sheets are left out.
 */
export function readSheets(folder) {
  const path = join(folder, DESCRIPTION)
  if (!existsSync(path))
    throw new Failure(`no sheets in ${folder}; draw them with npm run auto-sheets or body-sheets`)
  const { parts, ...description } = JSON.parse(readFileSync(path, 'utf8'))
  const withFiles = parts.map((part) => {
    const files = Object.keys(description.versions).map((version) => [
      version,
      join(folder, `${part.sheet}-${version}.jpg`),
    ])
    return { ...part, files: Object.fromEntries(files.filter(([, file]) => existsSync(file))) }
  })
  return { ...description, parts: withFiles.filter(({ files }) => Object.keys(files).length > 0) }
}
