// Generates the gallery of examples, and a page per example that runs the example and shows its source.

import { cpSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { readExamples } from '../../scripts/lib/examples.mjs'
import { ROOT } from '../../scripts/lib/run.mjs'

/** Writes the gallery, its pictures, and the pages of the examples. */
export function gatherExamples(folder) {
  const target = join(folder, 'examples')
  mkdirSync(target, { recursive: true })
  const examples = readExamples()
  for (const example of examples) writeFileSync(join(target, `${example.name}.md`), page(example))
  writeFileSync(join(target, 'index.md'), gallery(examples))
  cpSync(join(ROOT, 'examples/pictures'), join(folder, 'public/examples/pictures'), { recursive: true })
}

function gallery(examples) {
  const cards = examples.map(({ source, ...card }) => card)
  const parts = [
    '---\naside: false\npageClass: gallery\n---',
    '# Examples',
    'Each example is one file in the folder `examples`, without a bundler. It runs here beside its source.',
    `<script setup>\nconst examples = ${JSON.stringify(cards)}\n</script>`,
    '<ExampleGallery :examples="examples" />',
  ]
  return `${parts.join('\n\n')}\n`
}

/**
 * Returns the page of an example. The title, description and keywords are on the page so that the search of the site
 * finds them.
 */
function page({ name, title, description, keywords, source }) {
  const parts = [
    `---\naside: false\npageClass: example\ndescription: ${JSON.stringify(description)}\n---`,
    `# ${title}`,
    description,
    `<LiveExample name="${name}" title="${title}" />`,
    `\`examples/${name}.html\``,
    `\`\`\`html\n${source.trimEnd()}\n\`\`\``,
    ...modulesOf(source).map(details),
    `Keywords: ${keywords}`,
  ]
  return `${parts.join('\n\n')}\n`
}

/** Returns the modules in the folder `examples` that a source imports, directly or indirectly. */
function modulesOf(source, found = []) {
  for (const [, module] of source.matchAll(/from '\.\/([\w-]+\.js)'/g)) {
    if (found.includes(module)) continue
    found.push(module)
    modulesOf(readModule(module), found)
  }
  return found
}

function details(module) {
  return `::: details \`examples/${module}\`, which it imports\n\`\`\`js\n${readModule(module).trimEnd()}\n\`\`\`\n:::`
}

function readModule(module) {
  return readFileSync(join(ROOT, 'examples', module), 'utf8')
}
