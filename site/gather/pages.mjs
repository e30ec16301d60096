import { cpSync, mkdirSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { ROOT } from '../../scripts/lib/run.mjs'
import { pageFiles, pageOf } from '../places.mjs'

const FIGURES = ['docs/figures']
/** Files that the site serves unchanged, because pages link to them. */
const PUBLIC = ['docs/schema']

/** Copies the Markdown files that become pages, their figures, and the files in `PUBLIC`. */
export function gatherPages(folder) {
  for (const file of pageFiles()) copy(file, join(folder, pageOf(file)))
  for (const path of FIGURES) copy(path, join(folder, path))
  for (const path of PUBLIC) copy(path, join(folder, 'public', path))
}

function copy(path, target) {
  mkdirSync(dirname(target), { recursive: true })
  cpSync(join(ROOT, path), target, { recursive: true })
}
