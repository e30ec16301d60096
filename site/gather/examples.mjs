// A page for each example: it runs beside its source.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { ROOT } from '../../scripts/lib/run.mjs'
import { exampleNames } from '../places.mjs'

/** A module that examples share. */
const SHARED = 'portrait.js'

/** Writes the pages, and one that lists them. */
export function gatherExamples(folder) {
  const target = join(folder, 'examples')
  mkdirSync(target, { recursive: true })
  const examples = exampleNames().map((name) => ({ name, ...readExample(name) }))
  for (const example of examples) writeFileSync(join(target, `${example.name}.md`), page(example))
  const rows = examples.map(({ name, title }) => `| [${name}](${name}.md) | ${title} |`)
  const index = [
    '# Examples',
    'Each is one file in the folder `examples`, without a bundler, and runs here beside its source.',
    ['| example | what it shows |', '| --- | --- |', ...rows].join('\n'),
  ]
  writeFileSync(join(target, 'index.md'), `${index.join('\n\n')}\n`)
}

function readExample(name) {
  const source = readFileSync(join(ROOT, 'examples', `${name}.html`), 'utf8')
  const [, title] = /<title>Furrow: ([^<]*)<\/title>/.exec(source)
  return { source, title }
}

function page({ name, title, source }) {
  const parts = [
    '---\naside: false\npageClass: example\n---',
    `# ${title[0].toUpperCase()}${title.slice(1)}`,
    `<LiveExample name="${name}" title="${title}" />`,
    `\`examples/${name}.html\``,
    `\`\`\`html\n${source.trimEnd()}\n\`\`\``,
  ]
  if (source.includes(`./${SHARED}`)) {
    const shared = readFileSync(join(ROOT, 'examples', SHARED), 'utf8').trimEnd()
    parts.push(`::: details \`examples/${SHARED}\`, which it imports\n\`\`\`js\n${shared}\n\`\`\`\n:::`)
  }
  return `${parts.join('\n\n')}\n`
}
