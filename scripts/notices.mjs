// `npm run notices`: writes the licences of all packages that furrow-cli installs to a file.

import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { Failure, main, ROOT } from './lib/run.mjs'

const PACKAGE = 'packages/cli'
const TARGET = join(ROOT, PACKAGE, 'THIRD_PARTY_NOTICES.md')

/** Licences from the repositories of packages that ship none, named after the package. */
const LICENCES = join(ROOT, 'scripts/licences')

/** Longer than any fence inside a licence. */
const FENCE = '````'

const { packages } = JSON.parse(readFileSync(join(ROOT, 'package-lock.json'), 'utf8'))

await main(() => {
  const [, , target = TARGET] = process.argv
  writeFileSync(target, notices(listInstalled()))
})

/** Lists all direct and indirect dependencies, sorted by name and version: `path` in node_modules, and the lock file's entry. */
function listInstalled() {
  const found = new Map()
  const visit = (from) => {
    const { dependencies, peerDependencies, peerDependenciesMeta, optionalDependencies } = packages[from]
    for (const name of Object.keys({ ...dependencies, ...peerDependencies, ...optionalDependencies })) {
      if (peerDependenciesMeta?.[name]?.optional) continue
      const path = resolvePackage(name, from)
      if (found.has(path)) continue
      found.set(path, { name, path, ...packages[path] })
      visit(path)
    }
  }
  visit(PACKAGE)
  const key = ({ name, version }) => `${name} ${version}`
  return [...found.values()].sort((a, b) => (key(a) < key(b) ? -1 : 1))
}

/** Resolves a dependency as Node does: in the package's own node_modules, then in those of its parent folders. */
function resolvePackage(name, from) {
  for (let folder = from; ; folder = folder.replace(/\/?[^/]*$/, '')) {
    const path = join(folder, 'node_modules', name).replaceAll('\\', '/')
    if (packages[path]) return path
    if (folder === '') throw new Failure(`${from} depends on ${name}, which package-lock.json does not list`)
  }
}

function notices(installed) {
  const everywhere = installed.filter(({ optional }) => !optional)
  const somewhere = installed.filter(({ optional }) => optional)
  const list = (entries) => entries.map(({ name, version, license }) => `- ${name} ${version}: ${license}`)
  const lines = [
    '# Third-party notices',
    'npm installs these packages with `furrow-cli`. The code that `dist/page` contains of them is named in `dist/page/LICENSES.md`.',
    list(everywhere).join('\n'),
    'And on the platforms that they are made for:',
    list(somewhere).join('\n'),
    ...[...byText(everywhere)].map(
      ([text, names]) => `## ${[...names].join(', ')}\n\n${FENCE}text\n${text}\n${FENCE}`,
    ),
  ]
  return `${lines.join('\n\n')}\n`
}

/** Groups package names by licence text. */
function byText(entries) {
  const texts = new Map()
  for (const entry of entries) {
    const text = readLicence(entry)
    texts.set(text, (texts.get(text) ?? new Set()).add(entry.name))
  }
  return texts
}

/** Reads a package's licence and notices from the package, or from `scripts/licences`. */
function readLicence({ name, path }) {
  const folder = join(ROOT, path)
  const files = readdirSync(folder)
    .sort()
    .filter((file) => /^(licen[cs]e|notices?|third.*notices?)\b/i.test(file))
    .map((file) => join(folder, file))
  const own = join(LICENCES, `${name}.txt`)
  if (files.length === 0 && existsSync(own)) files.push(own)
  if (files.length === 0)
    throw new Failure(`${name} ships no licence; add it as scripts/licences/${name}.txt`)
  return files.map((file) => readFileSync(file, 'utf8').replaceAll('\r', '').trimEnd()).join('\n\n')
}
