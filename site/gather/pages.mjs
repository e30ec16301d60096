import { cpSync, mkdirSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { ROOT } from '../../scripts/lib/run.mjs'
import { pageFiles, pageOf } from '../places.mjs'

const FIGURES = ['docs/figures']
/** Files that pages link to and the site serves unchanged. */
const PUBLIC = ['docs/schema']

/** Copies the Markdown files, their figures and the files they link to. */
export function gatherPages(folder) {
  for (const file of pageFiles()) copy(file, join(folder, pageOf(file)))
  for (const path of FIGURES) copy(path, join(folder, path))
  for (const path of PUBLIC) copy(path, join(folder, 'public', path))
}

function copy(path, target) {
  mkdirSync(dirname(target), { recursive: true })
  cpSync(join(ROOT, path), target, { recursive: true })
}
