import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { ROOT } from './run.mjs'

/** Groups of examples, in the order of the gallery. */
export const GROUPS = ['Start', 'Motion', 'Skin', 'Materials', 'Engines and frameworks', 'Scale', 'Tools']

/** Returns the sorted names of the examples. The example `minimal` is the file examples/minimal.html. */
export function exampleNames() {
  return readdirSync(join(ROOT, 'examples'))
    .filter((name) => name.endsWith('.html'))
    .map((name) => name.slice(0, -'.html'.length))
    .sort()
}

/**
 * Reads the page of an example.
 *
 * @returns {{ name: string, source: string, title: string, description: string, keywords: string, group: string }}
 *   `title` does not contain `Furrow: `. `keywords` are separated by commas. A missing property is an empty text.
 */
export function readExample(name) {
  const source = readFileSync(join(ROOT, 'examples', `${name}.html`), 'utf8')
  const meta = (key) => new RegExp(`<meta name="${key}" content="([^"]*)">`).exec(source)?.[1] ?? ''
  return {
    name,
    source,
    title: /<title>Furrow: ([^<]*)<\/title>/.exec(source)?.[1] ?? '',
    description: meta('description'),
    keywords: meta('keywords'),
    group: meta('group'),
  }
}

/** Reads all examples in the order of the gallery: by group, then by name. */
export function readExamples() {
  const examples = exampleNames().map(readExample)
  return GROUPS.flatMap((group) => examples.filter((example) => example.group === group))
}
