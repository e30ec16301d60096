import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { ROOT } from './run.mjs'

/**
 * Returns the lines of a generated table in a page. The table is between the comments `NAME` and `end of NAME`.
 *
 * @param page path relative to the root of the repository.
 */
export function readTable(page, name) {
  return partsOf(page, name)[1].trim().split('\n')
}

/** Replaces the lines of a generated table, see `readTable`. */
export function writeTable(page, name, lines) {
  const [before, , after] = partsOf(page, name)
  const [begin, end] = marksOf(name)
  writeFileSync(join(ROOT, page), `${before}${begin}\n\n${lines.join('\n')}\n\n${end}${after}`)
}

const marksOf = (name) => [`<!-- ${name} -->`, `<!-- end of ${name} -->`]

function partsOf(page, name) {
  const [begin, end] = marksOf(name)
  const [before, rest = ''] = readFileSync(join(ROOT, page), 'utf8').split(begin)
  const [table, after] = rest.split(end)
  if (after === undefined) throw new Error(`${page}: missing table, got none between ${begin} and ${end}`)
  return [before, table, after]
}
